#include "gui/app/film_recorder.hpp"

#include "core/base/check.hpp"
#include "core/base/error.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/run_folder.hpp"
#include "gui/app/viewport_image.hpp"

#include <condition_variable>
#include <exception>
#include <map>
#include <mutex>
#include <stop_token>
#include <string_view>
#include <system_error>
#include <unistd.h>
#include <utility>
#include <vector>

namespace gaspard {

namespace fs = std::filesystem;

namespace {

/// A folder beside a file, for what the file is made of; gone with its content at the end. Its name is that
/// of an unfinished file (is_abandoned()).
class WorkFolder {
  public:
    explicit WorkFolder(const fs::path& file) {
        remove_those_of_others(file.parent_path());
        const std::string stem = ".gaspard-" + std::to_string(::getpid()) + "-film-";
        std::error_code error;
        for (int number = 0; !error; ++number) {
            path_ = file.parent_path() / (stem + std::to_string(number) + ".tmp");
            if (fs::create_directory(path_, error)) return;
        }
        throw MachineError("cannot make the folder " + path_.string() + ": " + error.message());
    }
    ~WorkFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    WorkFolder(const WorkFolder&) = delete;
    WorkFolder& operator=(const WorkFolder&) = delete;
    const fs::path& path() const { return path_; }

  private:
    /// Of programs that were killed.
    static void remove_those_of_others(const fs::path& folder) {
        std::error_code ignored;
        std::vector<fs::path> left;
        for (const auto& entry : fs::directory_iterator(folder, ignored))
            if (entry.is_directory(ignored) && is_abandoned(entry.path())) left.push_back(entry.path());
        for (const fs::path& one : left) fs::remove_all(one, ignored);
    }
    fs::path path_;
};

} // namespace

class FilmRecorder::FilmInWork {
  public:
    FilmInWork(FilmOrder order, std::shared_ptr<NoticeBoard> board)
        : order_(std::move(order)), board_(std::move(board)) {}

    /// On the film's thread: all of it. A sentence about the outcome.
    std::string make();
    /// On the window's thread: one frame.
    void lay_out();
    void forget_drawn() {
        std::vector<std::unique_ptr<PreparedImage>> drawn;
        const std::lock_guard lock(mutex_);
        drawn.swap(drawn_);
    }
    void cancel() { stop_.request_stop(); }
    Progress progress() const {
        const std::lock_guard lock(mutex_);
        return progress_;
    }

  private:
    /// A frame that waits for its layout.
    struct Wanted {
        int number = 0;
        FilmFrame frame;
        std::shared_ptr<ViewportPlanner> planner; ///< has prepared it
        const Gl* gl = nullptr;                   ///< of the film's thread
    };
    /// One that has it, or the reason why not.
    struct Laid {
        std::unique_ptr<PreparedImage> image;
        std::exception_ptr failure;
    };

    void write(const Film& film);
    void write_file(const Film& film, const FilmWriting& writing);
    Image draw(const Film& film, int number, const Gl& gl);
    void want(const Film& film, int number, const Gl& gl);
    void tell(const std::string& what, int number, int count);
    void show(Progress progress);

    const FilmOrder order_;
    const std::shared_ptr<NoticeBoard> board_;
    std::stop_source stop_;
    int asked_for_ = 0;           ///< frames, by the film's thread
    bool sequence_begun_ = false; ///< there is a folder with some of its files

    mutable std::mutex mutex_; ///< of all below
    std::condition_variable_any laid_out_;
    std::vector<Wanted> wanted_;
    std::map<int, Laid> laid_;
    std::vector<std::unique_ptr<PreparedImage>> drawn_; ///< to be destroyed on the window's thread
    Progress progress_{"film", 0};
};

std::string FilmRecorder::FilmInWork::make() {
    try {
        const auto fitting = [this](double done, std::string_view what) {
            show({"film: " + std::string(what), done});
        };
        const Film film(order_.plan, *order_.recording, order_.last, order_.scenario.view, fitting,
                        stop_.get_token());
        write(film);
        return "Film saved: " + order_.file.string() + ", " + std::to_string(film.frames()) +
               (film.frames() == 1 ? " frame" : " frames");
    } catch (const Interrupted&) {
        return sequence_begun_
                   ? "Film cancelled; the files that are in " + order_.file.string() + " are complete"
                   : std::string("Film cancelled; no file was written");
    }
}

void FilmRecorder::FilmInWork::write(const Film& film) {
    std::unique_ptr<OffscreenContext> context; // dies on the thread that it belongs to
    const FilmWriting writing{
        .formats = {order_.format},
        .draw =
            [&](int number) {
                if (!context) context = make_offscreen_context();
                return draw(film, number, context->gl());
            },
        .begun = [this](const std::string& what, int number, int count) { tell(what, number, count); },
        .stop = stop_.get_token()};
    if (!order_.format->several) return write_file(film, writing);
    const std::vector<std::string> names = film_file_names();
    check_no_folders(order_.file, names);
    if (const std::string present = first_present(order_.file, names); !order_.replace && !present.empty())
        throw InputError((order_.file / present).string() + " exists already; nothing was written");
    const FilmFolder folder(order_.file, film_record(order_.scenario, order_.plan, film), false);
    sequence_begun_ = true;
    write_film(film, order_.file, writing);
}

/// What the file is made of is beside it meanwhile.
void FilmRecorder::FilmInWork::write_file(const Film& film, const FilmWriting& writing) {
    const auto check = [this] {
        if (!order_.replace && fs::exists(order_.file))
            throw InputError(order_.file.string() + " exists already; nothing was written");
        if (fs::is_directory(order_.file))
            throw InputError(order_.file.string() + " is a folder; choose another name");
    };
    check(); // before the long work
    const std::vector<fs::path> made = check_writable(order_.file.parent_path());
    try {
        const WorkFolder folder(order_.file);
        write_film(film, folder.path(), writing);
        if (stop_.stop_requested()) throw Interrupted();
        check(); // it may have come into being meanwhile
        std::error_code error;
        fs::rename(folder.path() / order_.format->file, order_.file, error);
        if (error) throw MachineError("cannot write " + order_.file.string() + ": " + error.message());
    } catch (...) {
        remove_empty(made);
        throw;
    }
}

Image FilmRecorder::FilmInWork::draw(const Film& film, int number, const Gl& gl) {
    for (; asked_for_ <= number + 1 && asked_for_ < film.frames(); ++asked_for_) want(film, asked_for_, gl);
    std::unique_lock lock(mutex_);
    laid_out_.wait(lock, stop_.get_token(), [&] { return laid_.contains(number); });
    if (stop_.stop_requested()) throw Interrupted();
    const auto found = laid_.find(number);
    auto image = std::move(found->second.image);
    if (const auto failure = found->second.failure) std::rethrow_exception(failure);
    laid_.erase(found);
    lock.unlock();
    // Also if drawing is interrupted, the window's thread releases it.
    const auto give_back = [&] {
        const std::lock_guard again(mutex_);
        drawn_.push_back(std::move(image));
    };
    try {
        Image drawn = image->draw();
        give_back();
        return drawn;
    } catch (...) {
        give_back();
        throw;
    }
}

/// Each frame has a planner of its own, as in a film without a window, so that their pixels are equal.
void FilmRecorder::FilmInWork::want(const Film& film, int number, const Gl& gl) {
    Wanted wanted{number, film.frame(number), std::make_shared<ViewportPlanner>(), &gl};
    wanted.planner->prepare(wanted.frame);
    {
        const std::lock_guard lock(mutex_);
        wanted_.push_back(std::move(wanted));
    }
    board_->wake();
}

void FilmRecorder::FilmInWork::lay_out() {
    Wanted wanted;
    {
        const std::lock_guard lock(mutex_);
        if (wanted_.empty() || stop_.stop_requested()) return;
        wanted = std::move(wanted_.front());
        wanted_.erase(wanted_.begin());
    }
    const Values& view = wanted.frame.view;
    Laid laid;
    try {
        laid.image = std::make_unique<PreparedImage>(
            *wanted.frame.snapshot, view, static_cast<int>(view.integer("width")),
            static_cast<int>(view.integer("height")), scenario_title(order_.scenario),
            ImageOptions{.gl = wanted.gl, .stop = stop_.get_token(), .planner = std::move(wanted.planner)});
    } catch (...) {
        laid.failure = std::current_exception();
    }
    {
        const std::lock_guard lock(mutex_);
        laid_.emplace(wanted.number, std::move(laid));
        if (!wanted_.empty()) board_->wake(); // for the next call
    }
    laid_out_.notify_all();
}

void FilmRecorder::FilmInWork::tell(const std::string& what, int number, int count) {
    if (count > 1)
        show({"film: " + what + " " + std::to_string(number) + " of " + std::to_string(count),
              static_cast<double>(number - 1) / count});
    else
        show({"film: writing " + order_.file.filename().string(), 1});
}

void FilmRecorder::FilmInWork::show(Progress progress) {
    {
        const std::lock_guard lock(mutex_);
        progress_ = std::move(progress);
    }
    board_->wake();
}

FilmRecorder::FilmRecorder(std::shared_ptr<NoticeBoard> board) : board_(board), writer_(std::move(board)) {}

FilmRecorder::~FilmRecorder() { cancel(); }

void FilmRecorder::begin(FilmOrder order) {
    GASPARD_CHECK(!busy());
    film_ = std::make_shared<FilmInWork>(std::move(order), board_);
    writer_.run([task = film_]() mutable {
        const auto own = std::move(task); // released before the outcome is told
        return own->make();
    });
}

void FilmRecorder::cancel() {
    if (film_) film_->cancel();
}

std::optional<FilmRecorder::Progress> FilmRecorder::progress() const {
    if (!film_) return std::nullopt;
    return film_->progress();
}

void FilmRecorder::work() {
    if (!film_) return;
    film_->forget_drawn();
    film_->lay_out();
    if (film_.use_count() == 1) film_.reset(); // the film's thread has done with it
}

} // namespace gaspard
