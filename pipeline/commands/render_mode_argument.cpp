#include "pipeline/commands/render_mode_argument.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "calib/work/error.h"
#include "calib/work/printable.h"
#include "pipeline/text/hyphenated.h"

namespace lumi {
namespace {

std::string name_of(const PlainRival& rival) { return hyphenated(rival.name); }
std::string name_of(const ResampledRival& rival) { return hyphenated(rival.name); }

template <class Value>
std::vector<std::string> names_of(const std::vector<Value>& values) {
    std::vector<std::string> names;
    for (const Value& value : values) names.push_back(name_of(value));
    return names;
}

std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) text += i + 1 < names.size() ? ", " : " or ";
        text += names[i];
    }
    return text;
}

/// Null where none has the name.
template <class Rival>
const Rival* one_named(const std::string& name, const std::vector<Rival>& rivals) {
    const auto found = std::find_if(rivals.begin(), rivals.end(),
                                    [&](const Rival& rival) { return name_of(rival) == name; });
    return found == rivals.end() ? nullptr : &*found;
}

RivalChoice rival_or_none(const std::string& name) {
    return {one_named(name, plain_rivals()), one_named(name, resampled_rivals())};
}

bool is_rival(const std::string& name) {
    const RivalChoice choice = rival_or_none(name);
    return choice.plain != nullptr || choice.resampled != nullptr;
}

}  // namespace

std::string render_mode_names() { return listed(names_of(all_render_modes())); }
std::string debug_picture_names() { return listed(names_of(all_debug_pictures())); }

std::string rival_names() {
    std::vector<std::string> names = names_of(plain_rivals());
    for (std::string& name : names_of(resampled_rivals())) names.push_back(std::move(name));
    return listed(names);
}

RenderMode render_mode_from(const std::string& name) {
    if (const auto mode = render_mode_named(name)) return *mode;
    const std::string rival = hyphenated(name);
    throw Error(ErrorKind::kUsage, "E-RENDER-MODE", "there is no mode named " + name,
                is_rival(rival) ? "a method of others: `lumi render --rival " + rival +
                                      "` draws it, `lumi evaluate --rivals` measures it"
                                : "use " + render_mode_names());
}

DebugPicture debug_picture_from(const std::string& name) {
    if (const auto picture = debug_picture_named(name)) return *picture;
    throw Error(ErrorKind::kUsage, "E-RENDER-DEBUG", "there is no debug picture named " + name,
                "use " + debug_picture_names());
}

RivalChoice rival_named(const std::string& name) {
    if (is_rival(name)) return rival_or_none(name);
    throw Error(ErrorKind::kUsage, "E-RENDER-RIVAL", "there is no rival named " + printable(name),
                render_mode_named(name) ? "it is one of lumi's modes: use --mode " + name
                                        : "use " + rival_names());
}

}  // namespace lumi
