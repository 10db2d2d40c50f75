#include "gui/base/background_writer.hpp"

#include "core/base/error.hpp"
#include "core/base/this_thread.hpp"

#include <utility>

namespace gaspard {

std::filesystem::path free_name(const std::filesystem::path& folder, const std::string& stem,
                                const std::string& ending) {
    std::filesystem::path file = folder / (stem + ending);
    for (int number = 2; std::filesystem::exists(file); ++number)
        file = folder / (stem + "-" + std::to_string(number) + ending);
    return file;
}

BackgroundWriter::BackgroundWriter(std::shared_ptr<NoticeBoard> board)
    : board_(std::move(board)), thread_([this](std::stop_token stop) { work(stop); }) {}

BackgroundWriter::~BackgroundWriter() = default; // the jthread asks to stop, finishes the tasks, and joins

void BackgroundWriter::run(std::function<std::string()> task) {
    {
        std::lock_guard lock(mutex_);
        tasks_.push_back(std::move(task));
    }
    wake_.notify_one();
}

void BackgroundWriter::work(std::stop_token stop) {
    name_thread("writer");
    while (true) {
        std::unique_lock lock(mutex_);
        wake_.wait(lock, stop, [this] { return !tasks_.empty(); });
        if (tasks_.empty()) return; // asked to stop, and nothing is left to do
        const auto task = std::move(tasks_.front());
        tasks_.pop_front();
        lock.unlock();
        try {
            report_outcome(*board_, task);
        } catch (const Interrupted&) {
            board_->add({"Cancelled.", false});
        }
    }
}

void BackgroundWriter::write_new(OutputFolders folders, std::string folder, std::string name,
                                 std::string ending,
                                 std::function<void(const std::filesystem::path&)> write) {
    run([folders = std::move(folders), folder = std::move(folder), name = std::move(name),
         ending = std::move(ending), write = std::move(write)] {
        const WritableFolder place = writable_folder(folders, folder);
        const auto file = free_name(place.folder, name, ending);
        write(file);
        return "Saved " + file.string() + place.remark;
    });
}

} // namespace gaspard
