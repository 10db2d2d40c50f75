// Parameter rows: everything a user can turn is declared once, as a row beside the code that uses it.
// Slider, --set, TOML, `gaspard list`, tooltip and documentation are made from the row.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace gaspard {

/// real_or_auto: a number, or the text "auto", which leaves the choice to the program.
enum class ParameterKind { real, real_or_auto, integer, boolean, choice, text };
enum class ParameterScale { linear, logarithmic };

using Value = std::variant<double, std::int64_t, bool, std::string>;

/// What the program must know of a parameter beyond its value, whatever its key is called.
enum class ParameterRole {
    none,
    x,              ///< with the row of role y and the same `point`: a point of the plane that can be dragged
    y,
    latitude,       ///< with `longitude` and the same `point`: a point of the sphere that can be dragged
    longitude,
    seed,           ///< of random numbers
    control_points, ///< of a patch, as text
    defines_rows,   ///< other rows depend on its value, so it is set before them
};

struct ParameterRow {
    std::string key{};    ///< within its section: "amplitude"
    std::string label{};  ///< as a slider shows it: "Amplitude"
    std::string symbol{}; ///< as the paper writes it; may be empty
    std::string unit{};   ///< may be empty
    ParameterKind kind = ParameterKind::real;
    double minimum = -std::numeric_limits<double>::infinity(); ///< inclusive; of numbers only
    double maximum = std::numeric_limits<double>::infinity();  ///< inclusive; of numbers only
    ParameterScale scale = ParameterScale::linear;
    Value default_value = 0.0;
    std::vector<std::string> choices{}; ///< of kind choice only
    std::string help{};                 ///< one line
    ParameterRole role = ParameterRole::none;
    std::string point{};   ///< of coordinates only: which point it belongs to ("center")
    bool periodic = false;         ///< minimum and maximum are the same place
    std::optional<Value> remedy{}; ///< the value that often helps if a run fails
};

/// The first row with a role; null if there is none.
const ParameterRow* find_role(const std::vector<ParameterRow>& rows, ParameterRole role);

/// The values of one section ("monitor"), one for each of its rows. Always complete and always in range.
class Values {
  public:
    Values() = default;
    /// Takes the rows' defaults.
    Values(std::string section, std::vector<ParameterRow> rows);

    const std::string& section() const { return section_; }
    const std::vector<ParameterRow>& rows() const { return rows_; }
    bool has(std::string_view key) const;

    double real(std::string_view key) const;
    /// Nothing for "auto".
    std::optional<double> real_or_auto(std::string_view key) const;
    std::int64_t integer(std::string_view key) const;
    bool boolean(std::string_view key) const;
    const std::string& text(std::string_view key) const; ///< of kinds choice and text
    const Value& at(std::string_view key) const;

    /// Throws InputError: key unknown (names the nearest), wrong kind, not finite, or out of range.
    /// A whole number is taken where a real is wanted.
    void set(std::string_view key, const Value& value);
    /// The same from text as given on a command line.
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
/// Of the first row that has a remedy and another value; nothing if there is none.
std::optional<Remedy> find_remedy(const Values& values);
/// "domain.geometry_order = 2".
std::string describe(const Values& section, const Remedy& remedy);

/// Whether a value is as its row has it.
bool is_default(const Values& values, std::string_view key);
/// A number in the C locale that reads back to the same double.
std::string format_number(double value);
/// The same, or no text where there is no number: the cell of a table.
std::string format_number(const std::optional<double>& value);
std::string format_value(const Value& value);
/// What a row allows, for people: "1 to 480", "ring, bell".
std::string describe_range(const ParameterRow& row);
/// The candidate with the smallest edit distance to `word`; empty if none is close.
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);
/// " (did you mean 'x'?)", or nothing where no candidate is near.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

} // namespace gaspard
