// Parameter rows: each user-adjustable value is declared once, as a row beside the code that uses it. The row
// generates its slider, tooltip, --set key, TOML key, `gaspard list` entry and documentation.
#pragma once

#include "core/base/export.hpp"

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace gaspard GASPARD_API {

/// real_or_auto: a number, or the text "auto", for which the program chooses a value.
enum class ParameterKind { real, real_or_auto, integer, boolean, choice, text };
enum class ParameterScale { linear, logarithmic };

using Value = std::variant<double, std::int64_t, bool, std::string>;

/// Special meaning of a parameter, independent of its key.
enum class ParameterRole {
    none,
    x, ///< with role y and the same `point`: a draggable point of the plane
    y,
    z,        ///< the third coordinate of such a point, of a surface in space
    latitude, ///< with role longitude and the same `point`: a draggable point of the sphere
    longitude,
    seed,           ///< of the random number generator
    control_points, ///< of a spline patch, as text
    file,           ///< a path, relative to the folder of the scenario's file
    patch,          ///< which patch of a file; an integer is accepted as text
    defines_rows,   ///< other rows depend on its value, so it is set before them
    formula,        ///< in the coordinates; other names in it become rows
    time,           ///< a time: the clock sets it (scenario/clock.hpp)
    motion,         ///< a value as a formula in the time t, or empty
};

/// The ends of a slider.
struct SliderRange {
    double minimum = 0, maximum = 1;
    friend bool operator==(const SliderRange&, const SliderRange&) = default;
};

struct ParameterRow {
    std::string key{};    ///< key within its section: "amplitude"
    std::string label{};  ///< label of its slider: "Amplitude"
    std::string symbol{}; ///< symbol in the paper; may be empty
    std::string unit{};   ///< may be empty
    ParameterKind kind = ParameterKind::real;
    double minimum = -std::numeric_limits<double>::infinity(); ///< inclusive; numeric kinds only
    double maximum = std::numeric_limits<double>::infinity();  ///< inclusive; numeric kinds only
    ParameterScale scale = ParameterScale::linear;
    std::optional<SliderRange> slider{}; ///< if not the whole range, which may be too wide to slide along
    Value default_value = 0.0;
    std::vector<std::string> choices{};       ///< kind choice only
    std::vector<std::string> choice_labels{}; ///< what the window calls them; empty: as they are written
    std::string help{};                       ///< one line
    ParameterRole role = ParameterRole::none;
    std::string point{};   ///< coordinates only: the point they belong to ("center")
    bool periodic = false; ///< minimum and maximum are equivalent
    bool of_all_times = false; ///< of a computation as a whole: it has no formula in t (clock.hpp)
    bool detail = false;   ///< of less interest: the window shows it on demand, or if it is changed
    /// The value stands for (value - origin) / measure, a number that does not depend on size and place of
    /// the domain. It is kept when the domain changes.
    double origin = 0, measure = 1;
    std::optional<Value> remedy{}; ///< the value that often helps if a run fails
    std::string former_key{};      ///< of earlier versions; scenario files and --set may still use it
    /// Earlier texts of choices, each with the present one; set and parse still accept them.
    std::vector<std::pair<std::string, std::string>> former_choices{};
};

/// The same rows as details: all of them, or those with these keys.
std::vector<ParameterRow> as_details(std::vector<ParameterRow> rows);
std::vector<ParameterRow> as_details(std::vector<ParameterRow> rows, std::span<const std::string_view> keys);
/// The same rows, whose real numbers may have any value.
std::vector<ParameterRow> without_ranges(std::vector<ParameterRow> rows);
/// Whether rows of the scenario may depend on the value of this row.
bool redefines_rows(const ParameterRow& row);
/// The first row with a role; null if there is none.
const ParameterRow* find_role(const std::vector<ParameterRow>& rows, ParameterRole role);
/// The key of the row with this key or, if there is none, with this former key; empty if there is none.
std::string present_key(const std::vector<ParameterRow>& rows, std::string_view key);

/// The values of one section, such as "monitor": one value per row, always within its range.
class Values {
  public:
    Values() = default;
    /// Initialises every value with its row's default.
    Values(std::string section, std::vector<ParameterRow> rows);

    const std::string& section() const { return section_; }
    const std::vector<ParameterRow>& rows() const { return rows_; }
    bool has(std::string_view key) const;

    double real(std::string_view key) const;
    /// nullopt if the value is "auto".
    std::optional<double> real_or_auto(std::string_view key) const;
    std::int64_t integer(std::string_view key) const;
    bool boolean(std::string_view key) const;
    const std::string& text(std::string_view key) const; ///< kinds choice and text
    const Value& at(std::string_view key) const;

    /// Throws InputError if the key is unknown (the message names the nearest key), or if the value has the
    /// wrong kind, is not finite or is out of range. Integers are accepted where a real number is expected.
    void set(std::string_view key, const Value& value);
    /// Like set, with the value given as text on the command line.
    void parse(std::string_view key, std::string_view text);

    friend bool operator==(const Values& a, const Values& b) {
        return a.section_ == b.section_ && a.values_ == b.values_;
    }

  private:
    std::size_t index(std::string_view key) const;

    std::string section_;
    std::vector<ParameterRow> rows_;
    std::vector<Value> values_;
};

/// Another value of one parameter, which often helps if a run fails.
struct Remedy {
    std::string key;
    Value value;
};
/// The remedy of the first row whose value differs from it; nullopt if there is none.
std::optional<Remedy> find_remedy(const Values& values);
/// "domain.geometry_order = 2".
std::string describe(const Values& section, const Remedy& remedy);

/// Whether the value equals its row's default.
bool is_default(const Values& values, std::string_view key);
/// Shortest text, in the C locale, that reads back to the same double.
std::string format_number(double value);
/// The same; an empty string for nullopt.
std::string format_number(const std::optional<double>& value);
std::string format_value(const Value& value);
/// The values a row allows, as text: "1 to 480", "ring, bell".
std::string describe_range(const ParameterRow& row);
/// The candidate with the smallest edit distance to `word`; empty if none is close.
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);
/// " (did you mean 'x'?)" with the nearest candidate; empty if none is close.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

} // namespace GASPARD_API
