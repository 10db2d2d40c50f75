// A text field that is to get the keyboard. ImGui gives it a frame or two after it was asked to; what is
// typed meanwhile is meant for the field.
#pragma once

#include <string>
#include <string_view>

namespace gaspard {

class AwaitedField {
  public:
    static constexpr int longest_wait = 30; ///< frames; a field that is not drawn never gets the keyboard

    void want(std::string key);
    /// The field is wanted, and ImGui is to be asked: again after some frames, because it forgets the wish if
    /// a window appears.
    bool wanted(std::string_view key) const;
    /// It has been wanted and has not got the keyboard yet.
    bool expects(std::string_view key) const { return key_ == key && pending(); }
    /// Asks ImGui; call it before the field is drawn.
    void ask();
    /// Call it after the field is drawn.
    void note(std::string_view key, bool active);
    /// What is typed is to wait for the field.
    bool pending() const;

  private:
    std::string key_; ///< empty: none
    int since_ = 0;   ///< the frame from which on it is waited for
    int asked_ = 0;   ///< the frame in which ImGui was asked last; 0: not yet
};

} // namespace gaspard
