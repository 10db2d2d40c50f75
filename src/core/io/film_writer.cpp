#include "core/io/film_writer.hpp"

#include "core/base/error.hpp"
#include "core/base/read_file.hpp"
#include "core/io/apng.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/formats.hpp"
#include "core/io/png_chunks.hpp"
#include "core/io/video.hpp"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <fstream>
#include <stdexcept>
#include <string_view>
#include <sys/file.h>
#include <system_error>
#include <unistd.h>

namespace gaspard {

namespace fs = std::filesystem;

namespace {

/// Whether a file ends so; only its end is read.
bool ends_with(const fs::path& file, std::string_view ending) {
    std::ifstream stream(file, std::ios::binary);
    std::string tail(ending.size(), '\0');
    stream.seekg(-static_cast<std::streamoff>(tail.size()), std::ios::end);
    stream.read(tail.data(), static_cast<std::streamsize>(tail.size()));
    return stream && tail == ending;
}

/// Whether a file of an earlier part is there and whole. What this program writes is; but a copy that ran out
/// of space, or a disk that failed, may have left part of it, or a file without content. Images are compared
/// with their checksums. Of a mesh only its end is looked at: damage before that is not found.
bool is_whole(const fs::path& file) {
    std::error_code unknown;
    if (!fs::is_regular_file(file, unknown)) return false;
    if (file.extension() == ".vtu") return ends_with(file, "</VTKFile>\n");
    try {
        png_chunks(read_file(file), file);
        return true;
    } catch (const std::runtime_error&) { // it cannot be read, or is broken
        return false;
    }
}

class FilmParts {
  public:
    FilmParts(const Film& film, const fs::path& folder, const FilmWriting& writing)
        : film_(film), folder_(folder), writing_(writing) {}

    void draw_frames() const {
        make_folder(folder_ / "frames");
        for (int k = 0; k < film_.frames(); ++k) {
            const fs::path file = frame_file(folder_ / "frames", k, ".png");
            if (writing_.resumed && is_whole(file)) continue;
            begin("frame", k + 1, film_.frames());
            write_png(file, writing_.draw(k));
        }
    }

    void write(const FilmFormat& format) const {
        const fs::path images = folder_ / "frames", file = folder_ / format.file;
        const auto video = [&](VideoKind kind) {
            write_video(file, kind, images, film_.frames(), film_.rate(), film_.hold(), writing_.stop);
        };
        if (format.name == "pvd") return write_meshes();
        if (format.name == "png") return;
        begin(std::string(format.file), 1, 1);
        if (format.name == "apng") {
            std::vector<fs::path> frames;
            for (int k = 0; k < film_.frames(); ++k) frames.push_back(frame_file(images, k, ".png"));
            write_apng(file, frames, film_.rate(), film_.hold(), writing_.stop);
        }
        if (format.name == "gif") video(VideoKind::gif);
        if (format.name == "mp4") video(VideoKind::mp4);
        if (format.name == "webm") video(VideoKind::webm);
        if (format.name == "glb") {
            const MovingMesh moving = moving_mesh(film_);
            write_animated_glb(file, moving.frames, moving.rate);
        }
        if (format.name == "csv")
            write_atomically(file, trajectories_csv(film_, writing_.nodes, writing_.stop));
    }

  private:
    void write_meshes() const {
        make_folder(folder_ / "mesh");
        for (const int k : frames_with_meshes(film_)) {
            const fs::path file = frame_file(folder_ / "mesh", k, ".vtu");
            if (writing_.resumed && is_whole(file)) continue;
            begin("mesh", k + 1, film_.frames());
            write_vtu(file, *film_.frame(k).snapshot);
        }
        write_atomically(folder_ / "mesh.pvd", pvd_of(film_));
    }

    void begin(const std::string& what, int number, int count) const {
        if (writing_.stop.stop_requested()) throw Interrupted();
        if (writing_.begun) writing_.begun(what, number, count);
    }

    const Film& film_;
    const fs::path& folder_;
    const FilmWriting& writing_;
};

/// Files of another film go before film.json speaks of this one, and film.json first of all, so that nothing
/// passes for a part of this film, whenever the program is killed.
void clear_film(const fs::path& folder) {
    for (const std::string& name : film_file_names()) {
        if (name.find('/') != name.npos) continue; // one of several
        std::error_code error;
        if (!fs::remove(folder / name, error) && error)
            throw MachineError("cannot remove " + (folder / name).string() +
                               ", which is of another film: " + error.message());
    }
    remove_frames(folder / "frames", ".png");
    remove_frames(folder / "mesh", ".vtu");
}

} // namespace

void write_film(const Film& film, const fs::path& folder, const FilmWriting& writing) {
    const FilmParts parts(film, folder, writing);
    const auto& formats = writing.formats;
    if (std::any_of(formats.begin(), formats.end(), [](const FilmFormat* format) { return format->drawn; }))
        parts.draw_frames();
    for (const FilmFormat* format : formats) parts.write(*format);
}

FilmFolder::FilmFolder(const fs::path& folder, const std::string& record, bool resumed) : descriptor_(-1) {
    check_writable(folder);
    descriptor_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor_ >= 0 && flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
        ::close(descriptor_);
        throw InputError("another program is recording into " + folder.string() + "; choose another folder");
    }
    try {
        if (!resumed) clear_film(folder);
        for (const fs::path& part : {folder, folder / "frames", folder / "mesh"}) remove_unfinished(part);
        write_atomically(folder / "film.json", record);
    } catch (...) {
        if (descriptor_ >= 0) ::close(descriptor_);
        throw;
    }
}

FilmFolder::~FilmFolder() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

} // namespace gaspard
