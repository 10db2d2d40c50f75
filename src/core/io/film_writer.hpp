// Writes the files of a film (film_files.hpp) into a folder, one after the other.
//
// Each file is complete or not there, whenever this ends. The images of the frames come from the caller,
// since the core draws nothing.
#pragma once

#include "core/io/film_files.hpp"
#include "core/io/image.hpp"

#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

namespace gaspard {

struct FilmWriting {
    std::vector<const FilmFormat*> formats;
    std::size_t nodes = usual_film_nodes; ///< at most so many in trajectories.csv
    bool resumed = false;                 ///< frames and meshes that are there already, and whole, stay
    /// The image of a frame, of which the first is 0. Asked for in ascending order, on the calling thread.
    std::function<Image(int frame)> draw{};
    /// Told before each part: what is made, which one, of how many: "frame", 3, 64. Of a file that is made
    /// at once "film.mp4", 1, 1.
    std::function<void(const std::string& what, int number, int count)> begun{};
    std::stop_token stop{};
};
/// Into a folder that exists. Throws MachineError if a file cannot be written; Interrupted.
void write_film(const Film& film, const std::filesystem::path& folder, const FilmWriting& writing);

/// A folder of a film, into which no other program records as long as this lives.
class FilmFolder {
  public:
    /// Makes the folder if necessary, removes what programs that were killed have left unfinished, and writes
    /// film.json, `record` (film_record()). Files of an earlier film are removed first, unless it is resumed.
    /// Throws InputError if another program records there or nothing can be written.
    FilmFolder(const std::filesystem::path& folder, const std::string& record, bool resumed);
    ~FilmFolder();
    FilmFolder(const FilmFolder&) = delete;
    FilmFolder& operator=(const FilmFolder&) = delete;

  private:
    int descriptor_; ///< of the folder, locked
};

} // namespace gaspard
