#include <CLI/CLI.hpp>

#include "pipeline/commands/commands.h"

namespace lumi {
namespace {

/// Help that begins with an example.
class ExampleFirst final : public CLI::Formatter {
 public:
    explicit ExampleFirst(std::string example) : example_(std::move(example)) {}

    std::string make_help(const CLI::App* app, std::string name,
                          CLI::AppFormatMode mode) const override {
        return "Example: " + example_ + "\n\n" +
               CLI::Formatter::make_help(app, std::move(name), mode);
    }

 private:
    std::string example_;
};

}  // namespace

CLI::App& add_command(CLI::App& app, const std::string& name, const std::string& description,
                      const std::string& example) {
    CLI::App* command = app.add_subcommand(name, description);
    command->formatter(std::make_shared<ExampleFirst>(example));
    return *command;
}

}  // namespace lumi
