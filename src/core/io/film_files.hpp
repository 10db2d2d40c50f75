// The files of a film (core/tessellate/film.hpp): its frames one by one, and what is made of them.
//
//   film.json            what it shows: another command can go on with it
//   frames/00000.png     ...
//   film.apng .gif .mp4 .webm
//   mesh.pvd, mesh/00000.vtu   for ParaView; the time is the iteration
//   mesh.glb             one morph target per frame
//   trajectories.csv     where nodes are, in every frame
#pragma once

#include "core/scenario/scenario.hpp"
#include "core/tessellate/film.hpp"

#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

struct FilmFormat {
    std::string_view name, help, file;
    bool drawn = false;   ///< needs the frames as images
    bool ffmpeg = false;  ///< is made by that program
    bool several = false; ///< has many files, in a folder of their own
    bool timed = true;    ///< its frames follow each other at a rate; else it has each mesh once
};
const std::vector<FilmFormat>& film_formats();
/// Parses a list such as "apng,mp4". Throws InputError for an unknown name and where ffmpeg is missing.
std::vector<const FilmFormat*> parse_film_formats(std::string_view list);

/// Throws InputError for a format that shows another motion than the film has.
void check_film_formats(const FilmPlan& plan, const std::vector<const FilmFormat*>& formats);
/// The files of all formats in a folder, of numbered ones the first.
std::vector<std::string> film_file_names();

/// What film.json says: the scenario and all that decides what the frames show, with a hash of the files that
/// it reads. Equal texts, equal frames. Throws InputError if a file cannot be read.
std::string film_record(const Scenario& scenario, const FilmPlan& plan, const Film& film);

/// folder/00012.png
std::filesystem::path frame_file(const std::filesystem::path& folder, int frame, std::string_view suffix);
/// Removes the numbered files of another film. Throws MachineError if one cannot be removed.
void remove_frames(const std::filesystem::path& folder, std::string_view suffix);

/// The frames whose iterate is not that of the frame before: those that have a file of their own in mesh/.
std::vector<int> frames_with_meshes(const Film& film);
/// mesh.pvd, which lists the files mesh/00000.vtu, ... with the iterations as times.
std::string pvd_of(const Film& film);
inline constexpr std::size_t usual_film_nodes = 400; // of trajectories.csv
/// The frame, iteration, node and position of at most `nodes` nodes, evenly chosen, in these frames.
std::string trajectories_csv(const Film& film, std::size_t nodes, const std::stop_token& stop);
/// At most so many morph targets, evenly chosen from these frames.
inline constexpr int most_morph_targets = 400;
/// The frames of mesh.glb, and how many of them a second shows.
struct MovingMesh {
    std::vector<std::shared_ptr<const Snapshot>> frames;
    double rate = 0;
};
MovingMesh moving_mesh(const Film& film);

} // namespace gaspard
