// Looks for fonts of the system on a thread of its own: listing them and reading their files may take
// seconds.
#pragma once

#include "gui/base/system_fonts.hpp"

#include <condition_variable>
#include <functional>
#include <mutex>
#include <set>
#include <stop_token>
#include <thread>
#include <vector>

namespace gaspard {

class FontFinder {
  public:
    /// `wake` is called on the other thread when fonts have been found.
    explicit FontFinder(std::function<void()> wake);

    /// Begins to look for fonts with these characters; each character is looked for once only.
    void look_for(const std::vector<char32_t>& characters);
    /// Takes what has been found; true if that is more than before.
    bool collect();
    /// All that collect() has taken, no font twice.
    const std::vector<SystemFont>& fonts() const { return fonts_; }

  private:
    void work(std::stop_token stop);

    std::function<void()> wake_;
    std::vector<SystemFont> fonts_;
    std::set<char32_t> asked_;
    std::mutex mutex_;
    std::condition_variable_any begin_;
    std::vector<char32_t> wanted_;  ///< guarded by mutex_
    std::vector<SystemFont> found_; ///< guarded by mutex_
    std::jthread thread_;           ///< last, so that it ends before what it uses
};

} // namespace gaspard
