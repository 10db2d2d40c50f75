#include "gui/gl/draw_changes.hpp"

#include "core/base/fnv1a.hpp"

#include <algorithm>
#include <cmath>

namespace gaspard {

PixelRect area_of(const ImDrawList& list, const ImDrawData& data) {
    if (list.VtxBuffer.empty()) return {};
    ImVec2 low = list.VtxBuffer.front().pos, high = low;
    for (const ImDrawVert& corner : list.VtxBuffer) {
        low = {std::min(low.x, corner.pos.x), std::min(low.y, corner.pos.y)};
        high = {std::max(high.x, corner.pos.x), std::max(high.y, corner.pos.y)};
    }
    ImVec4 clip(high.x, high.y, low.x, low.y);
    for (const ImDrawCmd& command : list.CmdBuffer)
        clip = {std::min(clip.x, command.ClipRect.x), std::min(clip.y, command.ClipRect.y),
                std::max(clip.z, command.ClipRect.z), std::max(clip.w, command.ClipRect.w)};
    const auto down = [](float value, float from, float scale, float most) {
        return static_cast<int>(std::floor(std::clamp((value - from) * scale, 0.0F, most)));
    };
    const auto up = [](float value, float from, float scale, float most) {
        return static_cast<int>(std::ceil(std::clamp((value - from) * scale, 0.0F, most)));
    };
    const ImVec2 from = data.DisplayPos, scale = data.FramebufferScale;
    const float width = data.DisplaySize.x * scale.x, height = data.DisplaySize.y * scale.y;
    const int x = down(std::max(low.x, clip.x), from.x, scale.x, width),
              y = down(std::max(low.y, clip.y), from.y, scale.y, height);
    return {x, y, up(std::min(high.x, clip.z), from.x, scale.x, width) - x,
            up(std::min(high.y, clip.w), from.y, scale.y, height) - y};
}

DrawChanges::Print DrawChanges::print_of(const ImDrawList& list, const ImDrawData& data) {
    Print print{fnv1a_start, area_of(list, data)};
    const auto add = [&](const void* bytes, std::size_t count) {
        print.hash = fnv1a({static_cast<const char*>(bytes), count}, print.hash);
    };
    add(list.VtxBuffer.Data, static_cast<std::size_t>(list.VtxBuffer.size_in_bytes()));
    add(list.IdxBuffer.Data, static_cast<std::size_t>(list.IdxBuffer.size_in_bytes()));
    for (const ImDrawCmd& command : list.CmdBuffer) {
        const ImTextureID texture = command.GetTexID();
        add(&command.ClipRect, sizeof command.ClipRect);
        add(&texture, sizeof texture);
        add(&command.ElemCount, sizeof command.ElemCount);
    }
    return print;
}

PixelRect DrawChanges::follow(const ImDrawData& data) {
    now_.clear();
    for (int i = 0; i < data.CmdListsCount; ++i) now_.push_back(print_of(*data.CmdLists[i], data));
    PixelRect changed;
    const auto has = [](const std::vector<Print>& prints, const Print& print) {
        return std::any_of(prints.begin(), prints.end(),
                           [&](const Print& one) { return one.hash == print.hash; });
    };
    std::vector<std::uint64_t> kept_before, kept_now;
    const auto compare = [&](const std::vector<Print>& these, const std::vector<Print>& others,
                             std::vector<std::uint64_t>& kept) {
        for (const Print& print : these)
            if (has(others, print))
                kept.push_back(print.hash);
            else
                changed = around(changed, print.area);
    };
    compare(before_, now_, kept_before);
    compare(now_, before_, kept_now);
    if (kept_before != kept_now) // another order, so that others are in front
        for (const Print& print : now_) changed = around(changed, print.area);
    std::swap(before_, now_);
    return changed;
}

} // namespace gaspard
