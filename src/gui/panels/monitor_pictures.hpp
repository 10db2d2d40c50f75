// Small pictures of monitors for lists: the values of a monitor, sampled over the domain, in a colour map; of
// a sphere as a map of longitude and latitude. They are computed when they are first asked for, a few per
// frame, and kept.
#pragma once

#include "core/monitor/monitor.hpp"
#include "core/tessellate/colour_map.hpp"
#include "gui/gl/picture_sheet.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gaspard {

inline constexpr int monitor_picture_width = 64, monitor_picture_height = 48; // pixels

/// What a picture shows: the monitor of a type with these values, where the domain is. Equal subjects have
/// the same picture.
struct MonitorSubject {
    std::string type;
    Values values;
    Space space;
    Box region{};                      ///< around the domain; not used on a sphere
    std::string colours = "automatic"; ///< as view.color_map
    friend bool operator==(const MonitorSubject&, const MonitorSubject&) = default;
};

/// The picture; nothing if the monitor needs data that it has not, or cannot be made. What does not lie in
/// the region is transparent.
std::optional<Image> picture_of_monitor(const MonitorType& type, const MonitorSubject& subject,
                                        const Values* pde = nullptr);

class MonitorPictures {
  public:
    /// At the beginning of a frame, when the one before has been drawn. Forgets all pictures if there are too
    /// many.
    void begin_frame();
    /// Nothing if there is no picture of it, or if it comes in one of the next frames.
    std::optional<PicturePlace> find(const MonitorType& type, const MonitorSubject& subject,
                                     const Values* pde = nullptr);
    /// Whether pictures that this frame asked for are still to come.
    bool waiting() const { return waiting_; }

  private:
    struct Known {
        MonitorSubject subject;
        std::optional<PicturePlace> place;
    };
    std::vector<Known> known_;
    std::shared_ptr<PictureSheet> sheet_;
    int computed_ = 0; ///< in this frame
    bool waiting_ = false;
};

} // namespace gaspard
