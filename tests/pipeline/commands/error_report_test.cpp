#include "pipeline/commands/error_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "calib/work/error.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;

/// What goes through a stream while this lives.
class Overheard {
 public:
    explicit Overheard(std::ostream& stream) : stream_(stream), former_(stream.rdbuf()) {
        stream_.rdbuf(text_.rdbuf());
    }
    ~Overheard() { stream_.rdbuf(former_); }
    Overheard(const Overheard&) = delete;
    Overheard& operator=(const Overheard&) = delete;
    [[nodiscard]] std::string text() const { return text_.str(); }

 private:
    std::ostream& stream_;
    std::streambuf* former_;
    std::ostringstream text_;
};

struct Reported {
    int exit_code = 0;
    std::string out;
    std::string talk;
};

Reported reported(CommandContext& context, const std::function<void()>& work) {
    const Overheard out(std::cout);
    const Overheard talk(std::cerr);
    const int exit_code = run_and_report_errors(work, context);
    return {exit_code, out.text(), talk.text()};
}

TEST(ErrorReport, AResultAndWhatIsWrongWithItAreOneObject) {
    CommandContext context;
    context.json = true;
    const Reported report = reported(context, [&] {
        context.print_result(Json{{"figures", 3}});
        throw Error(ErrorKind::kPartialResult, "E-TEST-WORSE", "two are worse", "look");
    });
    EXPECT_EQ(report.exit_code, 5);
    const Json object = Json::parse(report.out);
    EXPECT_EQ(object.at("figures"), 3);
    EXPECT_EQ(object.at("error"), Json({{"code", "E-TEST-WORSE"},
                                        {"what", "two are worse"},
                                        {"advice", "look"},
                                        {"exit_code", 5}}));
    EXPECT_EQ(report.talk, "error E-TEST-WORSE: two are worse\n  -> look\n");
}

TEST(ErrorReport, ABugIsAnObjectToo) {
    CommandContext context;
    context.json = true;
    bool is_cleared = false;
    context.clear_bar = [&] { is_cleared = true; };
    const Reported report = reported(context, [] { throw std::logic_error("odd"); });
    EXPECT_EQ(report.exit_code, 1);
    const Json error = Json::parse(report.out).at("error");
    EXPECT_EQ(error.at("code"), "E-INTERNAL");
    EXPECT_EQ(error.at("what"), "odd");
    EXPECT_EQ(error.at("exit_code"), 1);
    EXPECT_THAT(report.talk, HasSubstr("error E-INTERNAL: odd\n  -> this is a bug of lumi"));
    EXPECT_TRUE(is_cleared);
}

TEST(ErrorReport, ThereIsAnObjectWhereACommandHasNothingToSay) {
    CommandContext context;
    context.json = true;
    const Reported report = reported(context, [] {});
    EXPECT_EQ(report.exit_code, 0);
    EXPECT_EQ(Json::parse(report.out), Json::object());
    EXPECT_EQ(report.talk, "");
}

TEST(ErrorReport, AnOddPathInTheResultDoesNotFailTheCommand) {
    CommandContext context;
    context.json = true;
    const Reported report = reported(context, [&] {
        context.print_result(Json{{"file", "caf\xe9.ply"}});
    });
    EXPECT_EQ(report.exit_code, 0);
    EXPECT_EQ(Json::parse(report.out).at("file"), "caf\xef\xbf\xbd.ply");
}

TEST(ErrorReport, PeopleReadTheResultAtOnceAndTheErrorBesideIt) {
    CommandContext context;
    const Reported report = reported(context, [&] {
        context.print_result(std::string("3 figures\n"));
        throw Error(ErrorKind::kBadInput, "E-TEST", "bad\x1b[2J", "look");
    });
    EXPECT_EQ(report.exit_code, 3);
    EXPECT_EQ(report.out, "3 figures\n");
    EXPECT_EQ(report.talk, "error E-TEST: bad\\x1b[2J\n  -> look\n");
}

}  // namespace
}  // namespace lumi
