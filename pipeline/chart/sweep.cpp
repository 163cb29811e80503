#include "pipeline/chart/sweep.h"

#include "calib/work/error.h"
#include "pipeline/chart/default_sweep.h"
#include "pipeline/config/config_variant.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxVariants = 1000;

std::vector<RenderMode> modes_named(const ConfigSection& section) {
    const std::vector<std::string> names = section.texts("modes", {});
    if (names.empty()) return all_render_modes();
    std::vector<RenderMode> modes;
    for (const std::string& name : names) {
        const auto mode = render_mode_named(name);
        if (!mode) section.refuse("modes", "names of modes as in `lumi render --mode`");
        modes.push_back(*mode);
    }
    return modes;
}

std::string label_of(const std::vector<SweepAxis>& axes, const std::vector<std::size_t>& choice) {
    std::string label;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        label += (label.empty() ? "" : " ") + axes[i].values[choice[i]];
    }
    return label.empty() ? "as configured" : label;
}

/// The next combination, the last axis changing fastest; false after the last one.
bool advance(std::vector<std::size_t>& choice, const std::vector<SweepAxis>& axes) {
    for (std::size_t i = axes.size(); i-- > 0;) {
        if (++choice[i] < axes[i].values.size()) return true;
        choice[i] = 0;
    }
    return false;
}

/// What is no option of the sweep was perhaps meant as a setting to try.
void expect_options_known(const ConfigSection& options) {
    try {
        options.expect_all_keys_known();
    } catch (const Error& error) {
        throw Error(error.kind(), error.code(), error.what(),
                    error.advice() +
                        " (settings to try are keys of other tables, without quotation "
                        "marks: depth.model = [\"plane\", \"sweep\"])");
    }
}

}  // namespace

Sweep read_sweep(const fs::path& file_or_folder) {
    const ConfigDocument document = ConfigDocument::open(file_or_folder);
    Sweep sweep;
    const ConfigSection options = document.options_of("sweep");
    sweep.modes = modes_named(options);
    sweep.repeats = options.integer("repeats", sweep.repeats);
    if (sweep.repeats < 1) options.refuse("repeats", "1 or more");
    expect_options_known(options);

    std::vector<ConfigList> lists = document.lists_of("sweep");
    sweep.is_default = lists.empty();
    if (sweep.is_default) lists = default_sweep(document);
    for (ConfigList& list : lists) list = with_all_spelled_out(std::move(list));
    std::size_t combinations = 1;
    for (const ConfigList& list : lists) {
        sweep.axes.push_back({list.setting, list.words()});
        combinations *= list.literals.size();
        if (combinations > kMaxVariants) {
            throw Error(ErrorKind::kUsage, "E-CHART-SIZE",
                        document.name() + ": the sweep has more than " +
                            std::to_string(kMaxVariants) + " combinations",
                        "try fewer values under [sweep]");
        }
    }
    std::vector<std::size_t> choice(sweep.axes.size(), 0);
    do {
        std::vector<ConfigChange> changes;
        for (std::size_t i = 0; i < lists.size(); ++i) {
            changes.push_back({lists[i].setting, lists[i].literals[choice[i]]});
        }
        sweep.variants.push_back(
            {choice, label_of(sweep.axes, choice), document.build_config_with(changes)});
    } while (advance(choice, sweep.axes));
    sweep.name = sweep.variants.front().config.name;
    return sweep;
}

}  // namespace lumi
