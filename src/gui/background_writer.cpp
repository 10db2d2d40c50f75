#include "gui/background_writer.hpp"

#include "core/io/atomic_file.hpp"

#include <exception>
#include <utility>

namespace gaspard {

void NoticeBoard::add(Notice notice) {
    {
        std::lock_guard lock(mutex_);
        notices_.push_back(std::move(notice));
    }
    if (notify_) notify_();
}

std::vector<Notice> NoticeBoard::take() {
    std::lock_guard lock(mutex_);
    return std::exchange(notices_, {});
}

void report_outcome(NoticeBoard& board, const std::function<std::string()>& task) {
    try {
        board.add({task(), false});
    } catch (const std::exception& error) {
        board.add({error.what(), true});
    }
}

std::filesystem::path free_name(const std::filesystem::path& folder, const std::string& stem,
                                const std::string& ending) {
    std::filesystem::path file = folder / (stem + ending);
    for (int number = 2; std::filesystem::exists(file); ++number)
        file = folder / (stem + "-" + std::to_string(number) + ending);
    return file;
}

void PictureWriter::write(std::filesystem::path folder, std::string name, Image image) {
    threads_.emplace_back(
        [this, folder = std::move(folder), name = std::move(name), image = std::move(image)] {
            std::lock_guard lock(one_at_a_time_);
            report_outcome(*board_, [&] {
                check_writable(folder);
                const auto file = free_name(folder, name, ".png");
                write_png(file, image);
                return "Saved " + file.string();
            });
        });
}

} // namespace gaspard
