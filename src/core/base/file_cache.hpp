// What was made of files, such as decoded images, kept while the files stay the same.
#pragma once

#include "core/base/export.hpp"

#include <cstddef>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

namespace gaspard GASPARD_API {

/// Keeps the few contents that were used last. May be used from several threads at once.
class FileCache {
  public:
    /// The content of a file (a path or a data: URI, as an absolute path) as `make` has made it; `purpose`
    /// distinguishes the contents that are made of one file, and implies the type T. Calls `make` if there is
    /// none, or if size or time of the file have changed since; what `make` throws is passed on.
    template <class T>
    std::shared_ptr<const T> get(const std::string& file, std::string_view purpose,
                                 const std::function<std::shared_ptr<const T>()>& make) {
        return std::static_pointer_cast<const T>(
            find(file, purpose, [&]() -> std::shared_ptr<const void> { return make(); }));
    }

  private:
    struct Entry {
        std::string key;   ///< file and purpose
        std::string state; ///< size and time
        std::shared_ptr<const void> content;
    };
    static constexpr std::size_t most = 8;

    std::shared_ptr<const void> find(const std::string& file, std::string_view purpose,
                                     const std::function<std::shared_ptr<const void>()>& make);

    std::mutex mutex_;
    std::list<Entry> entries_; ///< the last used first
};

} // namespace GASPARD_API
