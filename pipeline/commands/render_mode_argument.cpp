#include "pipeline/commands/render_mode_argument.h"

#include "calib/work/error.h"

namespace lumi {
namespace {

template <class Value>
std::string listed(const std::vector<Value>& values) {
    std::string text;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (i > 0) text += i + 1 < values.size() ? ", " : " or ";
        text += name_of(values[i]);
    }
    return text;
}

}  // namespace

std::string render_mode_names() { return listed(all_render_modes()); }
std::string debug_picture_names() { return listed(all_debug_pictures()); }

RenderMode render_mode_from(const std::string& name) {
    if (const auto mode = render_mode_named(name)) return *mode;
    throw Error(ErrorKind::kUsage, "E-RENDER-MODE", "there is no mode named " + name,
                "use " + render_mode_names());
}

DebugPicture debug_picture_from(const std::string& name) {
    if (const auto picture = debug_picture_named(name)) return *picture;
    throw Error(ErrorKind::kUsage, "E-RENDER-DEBUG", "there is no debug picture named " + name,
                "use " + debug_picture_names());
}

}  // namespace lumi
