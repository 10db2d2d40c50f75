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
#include <utility>

namespace gaspard GASPARD_API {

/// Keeps the few contents that were used last, as far as they fit into a budget; the last one in any case.
/// May be used from several threads at once.
class FileCache {
  public:
    explicit FileCache(std::size_t budget = std::size_t{512} << 20) : budget_(budget) {}

    /// The content of a file (a path or a data: URI, as an absolute path) as `make` has made it; `purpose`
    /// distinguishes the contents that are made of one file, and implies the type T. Calls `make` if there is
    /// none, or if the file has been replaced or changed since; what `make` throws is passed on. `bytes`: the
    /// memory that a content takes. `file` is empty if nothing is read: `purpose` then says what is computed.
    template <class T>
    std::shared_ptr<const T> get(const std::string& file, std::string_view purpose,
                                 const std::function<std::shared_ptr<const T>()>& make,
                                 std::size_t (*bytes)(const T&)) {
        return std::static_pointer_cast<const T>(find(file, purpose, [&]() -> Content {
            auto made = make();
            const std::size_t size = bytes(*made);
            return {std::move(made), size};
        }));
    }

  private:
    struct Content {
        std::shared_ptr<const void> object;
        std::size_t bytes = 0;
    };
    struct Entry {
        std::string key;   ///< file and purpose
        std::string state; ///< of the file
        Content content;
        std::size_t bytes() const { return key.size() + content.bytes; }
    };
    static constexpr std::size_t most = 8;

    std::shared_ptr<const void> find(const std::string& file, std::string_view purpose,
                                     const std::function<Content()>& make);
    void forget_oldest();

    std::size_t budget_; ///< bytes
    std::mutex mutex_;
    std::list<Entry> entries_; ///< the last used first
};

} // namespace GASPARD_API
