#include "pipeline/commands/known_photographs.h"

#include <algorithm>
#include <utility>

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

}  // namespace lumi
