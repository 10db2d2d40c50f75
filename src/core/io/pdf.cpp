#include "core/io/pdf.hpp"

#include "core/base/error.hpp"
#include "core/base/release.hpp"
#include "core/io/atomic_file.hpp"

#include <cairo-pdf.h>
#include <librsvg/rsvg.h>
#include <memory>

namespace gaspard {

namespace {

using Handle = std::unique_ptr<RsvgHandle, Release<g_object_unref>>;
using Surface = std::unique_ptr<cairo_surface_t, Release<cairo_surface_destroy>>;
using Context = std::unique_ptr<cairo_t, Release<cairo_destroy>>;

/// Throws with the sentence of an error, if there is one.
void check_no_error(GError* error) {
    if (error == nullptr) return;
    const std::string why = error->message;
    g_error_free(error);
    throw MachineError("cannot convert a drawing to PDF: " + why);
}

void check_no_error(cairo_status_t status) {
    if (status == CAIRO_STATUS_SUCCESS) return;
    throw MachineError(std::string("cannot convert a drawing to PDF: ") + cairo_status_to_string(status));
}

cairo_status_t append_bytes(void* to, const unsigned char* bytes, unsigned int count) {
    static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(bytes), count);
    return CAIRO_STATUS_SUCCESS;
}

} // namespace

std::string pdf_of_svg(const std::string& svg) {
    GError* error = nullptr;
    const auto* data = reinterpret_cast<const guint8*>(svg.data());
    const Handle handle(rsvg_handle_new_from_data(data, svg.size(), &error));
    check_no_error(error);
    constexpr double points_per_inch = 72, pixels_per_inch = 96; // of CSS
    double width = 0, height = 0;
    rsvg_handle_set_dpi(handle.get(), pixels_per_inch);
    if (!rsvg_handle_get_intrinsic_size_in_pixels(handle.get(), &width, &height))
        throw MachineError("cannot convert a drawing to PDF: it has no size");
    width *= points_per_inch / pixels_per_inch, height *= points_per_inch / pixels_per_inch;

    std::string bytes;
    const Surface surface(cairo_pdf_surface_create_for_stream(&append_bytes, &bytes, width, height));
    check_no_error(cairo_surface_status(surface.get()));
    // Without the time: the same drawing gives the same bytes.
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
    {
        const Context context(cairo_create(surface.get()));
        const RsvgRectangle page{0, 0, width, height};
        rsvg_handle_render_document(handle.get(), context.get(), &page, &error);
        check_no_error(error);
        check_no_error(cairo_status(context.get()));
    }
    cairo_surface_finish(surface.get());
    check_no_error(cairo_surface_status(surface.get()));
    return bytes;
}

void write_pdf(const std::filesystem::path& file, const std::string& svg) {
    write_atomically(file, pdf_of_svg(svg));
}

} // namespace gaspard
