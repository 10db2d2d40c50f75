#include "cli/commands.hpp"
#include "cli/exit_code.hpp"
#include "cli/interrupt_watch.hpp"
#include "core/base/error.hpp"
#include "core/base/user_path.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/image.hpp"
#include "core/io/run_folder.hpp"
#include "core/published/published.hpp"
#include "gui/app/viewport_image.hpp"

#include <algorithm>
#include <cstdio>

namespace gaspard {

namespace {

void print_table(const std::vector<PublishedRow>& rows) {
    std::size_t row_width = 21, quantity_width = 22;
    for (const auto& row : rows) {
        row_width = std::max(row_width, row.row.size());
        quantity_width = std::max(quantity_width, row.quantity.size());
    }
    const auto first = static_cast<int>(row_width), second = static_cast<int>(quantity_width);
    std::printf("%-*s  %-*s %14s %12s %12s  %s\n", first, "row", second, "quantity", "ours", "published",
                "difference", "note");
    std::size_t published = 0, different = 0;
    for (const auto& row : rows) {
        char number[40] = "";
        if (const auto by = difference(row)) std::snprintf(number, sizeof number, "%+.2e", *by);
        std::printf("%-*s  %-*s %14.7g %12s %12s  %s\n", first, row.row.c_str(), second, row.quantity.c_str(),
                    row.ours, row.published ? format_number(row.published->value).c_str() : "", number,
                    full_note(row).c_str());
        published += row.published ? 1 : 0;
        different += differs(row) ? 1 : 0;
    }
    if (published > 0)
        std::printf("%zu of %zu published numbers differ beyond the last digit printed\n", different,
                    published);
}

// All panels in one row, 800 x 800 pixels each.
Image draw(const Figure& figure) {
    std::vector<Panel> panels;
    for (const auto& [title, content, camera, colour, cut, lines] : figure.panels) {
        if (const auto* plot = std::get_if<Plot>(&content))
            panels.emplace_back(*plot);
        else
            panels.emplace_back(MeshPanel{title, std::get<std::shared_ptr<const Snapshot>>(content), colour,
                                          1, camera, cut, lines});
    }
    const auto columns = static_cast<int>(panels.size());
    return render_panels(panels, columns, 800 * columns, 800);
}

} // namespace

int reproduce_command(std::shared_ptr<const Catalogue> catalogue, const std::string& id,
                      const std::string& out, bool full, bool render) {
    if (id.empty()) {
        for (const auto& recipe : recipes())
            std::printf("%-14s %s\n", recipe.id.c_str(), recipe.title.c_str());
        return 0;
    }
    const Recipe recipe = find_recipe(id);
    const std::filesystem::path folder =
        out.empty() ? std::filesystem::path("gaspard-out") / id : user_path(out);
    check_no_folders(folder, {id + ".csv", id + ".png"});
    const auto made = check_writable(folder);
    const InterruptWatch interrupt;
    try {
        const auto announce = [](const std::string& what) { std::fprintf(stderr, "%s\n", what.c_str()); };
        const Reproduction result =
            (full && recipe.full ? recipe.full : recipe.make)(catalogue, announce, interrupt.token());
        print_table(result.rows);
        write_atomically(folder / (id + ".csv"), published_csv(result.rows));
        if (result.figure && render) write_png(folder / (id + ".png"), draw(*result.figure));
    } catch (const Interrupted&) {
        remove_empty(made);
        std::fprintf(stderr, "gaspard: interrupted; nothing was written\n");
        return exit_code(RunStatus::interrupted);
    }
    std::printf("files in %s\n", folder.string().c_str());
    return 0;
}

} // namespace gaspard
