#include "gui/app/thumbnails.hpp"

#include "core/scenario/catalogue.hpp"
#include "core/scenario/toml.hpp"
#include "gui_assets.hpp"

namespace gaspard {

namespace {

constexpr int most_per_frame = 8; // below 2 ms

} // namespace

std::string_view thumbnail_file(std::string_view scenario) {
    const std::string path = "assets/thumbnails/" + std::string(scenario) + ".png";
    for (const auto& file : gui_assets::files())
        if (file.path == path) return file.bytes;
    return {};
}

std::optional<PicturePlace> Thumbnails::find(std::string_view scenario) {
    if (const auto found = places_.find(scenario); found != places_.end()) return found->second;
    const std::string_view file = thumbnail_file(scenario);
    if (file.empty()) return std::nullopt;
    if (decoded_ >= most_per_frame) {
        waiting_ = true;
        return std::nullopt;
    }
    ++decoded_;
    if (!sheet_)
        sheet_ = std::make_shared<PictureSheet>(thumbnail_width, thumbnail_height,
                                                static_cast<int>(builtin_scenarios().size()));
    const PicturePlace place = sheet_->add(decode_png(file, std::string(scenario)));
    places_.emplace(scenario, place);
    return place;
}

} // namespace gaspard
