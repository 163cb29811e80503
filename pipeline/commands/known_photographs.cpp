#include "pipeline/commands/known_photographs.h"

#include <algorithm>
#include <utility>

#include "calib/work/printable.h"
#include "pipeline/evaluate/held_out_beside.h"
#include "render/paths/photograph_eye.h"

namespace lumi {

KnownPhotographs known_photographs(const std::filesystem::path& package,
                                   const Lumigraph& lumigraph) {
    KnownPhotographs known{names_of_views(lumigraph), {}};
    std::vector<std::string>& names = known.names;
    try {
        for (std::string& name : held_out_names_beside(package)) {
            if (std::find(names.begin(), names.end(), name) == names.end())
                names.push_back(std::move(name));
        }
    } catch (const Error& error) {
        known.failure = error;
    }
    return known;
}

KnownPhotograph photograph_named(const std::string& wanted, const std::filesystem::path& package,
                                 const Lumigraph& lumigraph) {
    const KnownPhotographs known = known_photographs(package, lumigraph);
    const std::vector<std::string>& names = known.names;
    const std::optional<int> index = index_of_name(names, wanted);
    const auto packed = static_cast<int>(lumigraph.views.size());
    if (index && *index < packed) {
        const LumigraphView& view = lumigraph.views[static_cast<std::size_t>(*index)];
        return {eye_at(view), turned_upright(view.photograph, view.exif_orientation), true};
    }
    if (index) {
        const std::string& name = names[static_cast<std::size_t>(*index)];
        for (HeldOutView& beside : held_out_views_beside(package, 0))
            if (beside.name == name) return {beside.eye, std::move(beside.photograph), false};
    }
    if (known.failure) throw Error(*known.failure);
    throw Error(ErrorKind::kUsage, "E-RENDER-VIEW",
                "expected the name of one photograph, of the package or held out from it, found '" +
                    printable(wanted) + "'",
                "there are: " + listed_names(names) + "; `lumi inspect PACKAGE` lists all of them");
}

}  // namespace lumi
