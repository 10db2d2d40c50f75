// A text field for a formula: several lines in letters of equal width, what is wrong with it below the field
// while one types, and a list of functions and variables to insert.
//
// A formula is applied by Enter, by a pause in typing, or when the field is left. One that is wrong stays in
// the field, with the reason, until it is mended or taken back; the value is the last good one meanwhile. If
// other values change so that it becomes valid, the reason goes, and Enter applies the formula. It is not
// applied by itself: an undo that made it valid could then not be redone.
#pragma once

#include "gui/base/item_rectangles.hpp"
#include "gui/base/theme.hpp"
#include "gui/panels/awaited_field.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

/// What is wrong with a formula.
struct FormulaComplaint {
    std::string text;
    std::optional<std::size_t> character{}; ///< that it is about, from 1; a letter of several bytes is one
};

/// A function or a variable of the list that one can insert.
struct FormulaWord {
    std::string text; ///< "atan2(y, x)"
    std::string help; ///< "angle of (x, y)"; may be empty
    bool function = false;
};

/// A formula in lines of at most `columns` letters where it has blanks to break it at; other blanks stay.
std::string broken_at_blanks(std::string formula, std::size_t columns);
/// The same formula in one line, character by character.
std::string in_one_line(std::string formula);
/// What is inserted for a word: a variable, or a function up to its opening parenthesis.
std::string inserted_text(const FormulaWord& word);

/// The part of a formula that a complaint is about, with what stands around it.
struct FormulaExcerpt {
    std::string before, place, after;
};
FormulaExcerpt excerpt_at(std::string_view formula, std::size_t character, std::size_t around);

class FormulaField {
  public:
    static constexpr double pause = 0.6; ///< seconds without a key after which a formula is applied

    struct Context {
        const Theme& theme;
        /// Filled with `key`, `key`.help, `key`.complaint or `key`.valid, and, while the list is open,
        /// `key`+WORD.
        ItemRectangles& items;
        const std::vector<FormulaWord>& words; ///< of the list of draw_help()
        std::function<std::optional<FormulaComplaint>(const std::string&)> check;
        float width = 0;           ///< 0: as much as there is
        int least_lines = 2;       ///< the field is as high
        std::size_t situation = 0; ///< another number when `check` may find something else
    };
    /// Draws the field with `value` in it unless another formula is being typed.
    /// Returns the formula that is to be applied.
    std::optional<std::string> draw(const std::string& key, const std::string& value, const Context& context);
    /// The button of the list; draw it before the field, in the line of its label.
    void draw_help(const std::string& key, const Context& context);
    /// The formula applied last was refused: it stays in the field with this reason.
    void refuse(const std::string& why);
    /// Forgets what is typed into a field: it has its value again.
    void restore(std::string_view key);
    /// Whether the field has a formula that was not applied.
    bool has_draft(std::string_view key) const { return drafts_.find(key) != drafts_.end(); }
    /// The field gets the keyboard, with the cursor at the end.
    void focus(const std::string& key);
    /// A field is about to get the keyboard.
    bool awaits_text() const { return focus_.pending(); }
    /// Something will happen without input: a pause ends.
    bool waiting() const;

  private:
    struct Draft {
        std::string text;    ///< in lines
        std::string over;    ///< the value that it replaces
        std::string applied; ///< in one line; empty: not yet
        double typed_at = 0;
        bool unread = false; ///< typed since it was last applied or found wrong
        std::optional<FormulaComplaint> complaint{};
        bool complained = false;   ///< it is shown: not at once, as most formulas are half typed
        bool refused = false;      ///< by the solver
        bool freed = false;        ///< it was wrong, and other values have made it valid
        std::size_t situation = 0; ///< in which it was checked
    };
    struct Cursor {
        int at = -1;                 ///< in bytes; negative: at the end
        std::optional<int> wanted{}; ///< beyond the end: at the end
    };
    bool edit(const std::string& key, std::string& text, bool wrong, float width, const Context& context);
    static void check_again(Draft& draft, bool entered, const Context& context);
    void draw_complaint(const std::string& key, const Draft& draft, const Context& context) const;
    void forget_if_done(const std::string& key, const std::string& value, bool active);

    std::map<std::string, Draft, std::less<>> drafts_; ///< by key
    std::string last_applied_;                         ///< the key
    std::map<std::string, Cursor, std::less<>> cursors_;
    std::string insert_into_, inserted_; ///< the word chosen in the list of a field, for its next frame
    AwaitedField focus_;
};

} // namespace gaspard
