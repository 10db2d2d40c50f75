#include "core/io/film_files.hpp"

#include "core/base/error.hpp"
#include "core/base/join.hpp"
#include "core/io/video.hpp"
#include "core/scenario/data_files.hpp"
#include "core/scenario/toml.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <system_error>

namespace gaspard {

namespace fs = std::filesystem;

const std::vector<FilmFormat>& film_formats() {
    static const std::vector<FilmFormat> formats{
        {.name = "png",
         .help = "The frames as numbered images",
         .file = "frames",
         .drawn = true,
         .several = true},
        {.name = "apng", .help = "Animated PNG, for browsers and slides", .file = "film.apng", .drawn = true},
        {.name = "gif",
         .help = "Animated GIF (needs ffmpeg)",
         .file = "film.gif",
         .drawn = true,
         .ffmpeg = true},
        {.name = "mp4",
         .help = "H.264 video (needs ffmpeg)",
         .file = "film.mp4",
         .drawn = true,
         .ffmpeg = true},
        {.name = "webm",
         .help = "VP9 video (needs ffmpeg)",
         .file = "film.webm",
         .drawn = true,
         .ffmpeg = true},
        {.name = "pvd",
         .help = "Series of VTU files for ParaView",
         .file = "mesh.pvd",
         .several = true,
         .timed = false},
        {.name = "glb", .help = "Animated glTF, one morph target per frame", .file = "mesh.glb"},
        {.name = "csv", .help = "Trajectories of nodes", .file = "trajectories.csv", .timed = false},
    };
    return formats;
}

std::vector<const FilmFormat*> parse_film_formats(std::string_view list) {
    std::vector<const FilmFormat*> chosen;
    std::vector<std::string> names;
    for (const FilmFormat& format : film_formats()) names.emplace_back(format.name);
    for (const std::string_view name : split(list, ",")) {
        if (list.empty()) break;
        const auto format = std::find_if(film_formats().begin(), film_formats().end(),
                                         [&](const FilmFormat& one) { return one.name == name; });
        if (format == film_formats().end())
            throw InputError("unknown format '" + std::string(name) + "' of films" +
                             did_you_mean(name, names));
        if (format->ffmpeg) check_ffmpeg(name);
        if (std::find(chosen.begin(), chosen.end(), &*format) == chosen.end()) chosen.push_back(&*format);
    }
    if (chosen.empty()) throw InputError("no format is given, such as apng");
    return chosen;
}

void check_film_formats(const FilmPlan& plan, const std::vector<const FilmFormat*>& formats) {
    for (const FilmFormat* format : formats)
        if (!format->drawn && !plan.motions.shows_iterates())
            throw InputError("the format " + std::string(format->name) +
                             " has the iterates of a solve; ask for the motion iterations or time");
}

std::vector<std::string> film_file_names() {
    std::vector<std::string> names{"film.json", "frames/00000.png", "mesh/00000.vtu"};
    for (const FilmFormat& format : film_formats())
        if (format.name != "png") names.emplace_back(format.file);
    return names;
}

std::string film_record(const Scenario& scenario, const FilmPlan& plan, const Film& film) {
    std::vector<std::string_view> motions;
    for (const FilmMotionRow& row : film_motions())
        if (plan.motions.*row.member) motions.push_back(row.name);
    nlohmann::ordered_json json{{"scenario", scenario.name},     {"modified", scenario.modified},
                                {"motions", join(motions, ",")}, {"frames", film.frames()},
                                {"first", film.iteration(0)},    {"last", film.iteration(film.frames() - 1)}};
    if (has_data_files(scenario)) json["files"] = std::to_string(hash_of_data(scenario));
    if (plan.motions.camera) json["from"] = plan.from, json["to"] = plan.to;
    json["values"] = to_toml(scenario);
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

fs::path frame_file(const fs::path& folder, int frame, std::string_view suffix) {
    std::array<char, 16> number{};
    std::snprintf(number.data(), number.size(), "%05d", frame);
    return folder / (number.data() + std::string(suffix));
}

void remove_frames(const fs::path& folder, std::string_view suffix) {
    std::vector<fs::path> frames;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
        const std::string stem = entry.path().stem().string();
        const bool number = stem.size() == 5 && stem.find_first_not_of("0123456789") == stem.npos;
        if (number && entry.path().extension() == suffix) frames.push_back(entry.path());
    }
    for (const fs::path& frame : frames)
        if (!fs::remove(frame, error) && error)
            throw MachineError("cannot remove " + frame.string() +
                               ", which is of another film: " + error.message());
}

std::vector<int> frames_with_meshes(const Film& film) {
    std::vector<int> frames;
    for (int k = 0; k < film.frames(); ++k)
        if (k == 0 || film.iteration(k) != film.iteration(k - 1)) frames.push_back(k);
    return frames;
}

std::string pvd_of(const Film& film) {
    std::string text = "<?xml version=\"1.0\"?>\n"
                       "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
                       "  <Collection>\n";
    for (const int k : frames_with_meshes(film))
        text += "    <DataSet timestep=\"" + format_number(film.moment(k)) +
                "\" group=\"\" part=\"0\" file=\"" + frame_file("mesh", k, ".vtu").string() + "\"/>\n";
    return text + "  </Collection>\n</VTKFile>\n";
}

std::string trajectories_csv(const Film& film, std::size_t nodes, const std::stop_token& stop) {
    std::string text;
    for (const int k : frames_with_meshes(film)) {
        if (stop.stop_requested()) throw Interrupted();
        const FilmFrame frame = film.frame(k);
        const Points& x = frame.snapshot->x;
        const bool in_space = frame.snapshot->mesh->space_dimension == 3,
                   on_line = frame.snapshot->mesh->space_dimension == 1, in_time = film.in_time();
        if (k == 0)
            text = std::string("frame,iteration") + (in_time ? ",time" : "") + ",node,x" +
                   (on_line ? "" : ",y") + (in_space ? ",z" : "") + "\n";
        const std::size_t shown = std::min(nodes, x.size());
        for (std::size_t i = 0; i < shown; ++i) {
            const std::size_t node = i * x.size() / shown;
            text += std::to_string(k) + ',' + std::to_string(frame.iteration) + ',';
            if (in_time) text += format_number(film.moment(k)) + ',';
            text += std::to_string(node) + ',' + format_number(x.x[node]);
            if (!on_line) text += ',' + format_number(x.y[node]);
            if (in_space) text += ',' + format_number(x.z[node]);
            text += '\n';
        }
    }
    return text;
}

MovingMesh moving_mesh(const Film& film) {
    const std::vector<int> all = frames_with_meshes(film);
    const std::size_t count = std::min(all.size(), std::size_t{most_morph_targets + 1});
    MovingMesh moving{{}, film.rate()};
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t k = count > 1 ? i * (all.size() - 1) / (count - 1) : 0;
        moving.frames.push_back(film.frame(all[k]).snapshot);
    }
    if (count > 1) // as long as the film
        moving.rate = film.rate() * static_cast<double>(count - 1) / std::max(1, film.frames() - 1);
    return moving;
}

} // namespace gaspard
