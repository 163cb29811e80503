#include "render/gl/program.h"

#include <epoxy/gl.h>

#include <array>
#include <glm/gtc/type_ptr.hpp>

#include "calib/work/error.h"
#include "render/gl/lookup_meter.h"

namespace lumi {

namespace {

void delete_shader(unsigned name) { glDeleteShader(name); }
using Shader = ObjectName<delete_shader>;

constexpr const char* kEsHeader =
    "#version 300 es\n"
    "precision highp float;\n"
    "precision highp int;\n"
    "precision highp sampler2DArray;\n";
constexpr const char* kCoreHeader = "#version 330 core\n";

Error refused(const std::string& name, const std::string& step, const std::string& log) {
    return {ErrorKind::kResources, "E-GL-SHADER",
            "program " + name + " does not " + step + ": " + log,
            "report this with the output of `lumi doctor`; the software renderer "
            "(LIBGL_ALWAYS_SOFTWARE=1) is a way round it"};
}

std::string full_source(const std::string& stage, const std::vector<std::string_view>& sources,
                        const std::vector<std::string>& definitions) {
    std::string text = epoxy_is_desktop_gl() ? kCoreHeader : kEsHeader;
    if (stage == "LUMI_FRAGMENT") text += lookup_counting_source();
    text += "#define " + stage + "\n";
    for (const std::string& definition : definitions) text += "#define " + definition + "\n";
    for (const std::string_view source : sources) text += source;
    return text;
}

Shader compile(const std::string& name, GLenum stage, const std::string& source) {
    Shader shader(glCreateShader(stage));
    const char* text = source.c_str();
    glShaderSource(shader.get(), 1, &text, nullptr);
    glCompileShader(shader.get());
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader.get(), GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_TRUE) return shader;
    std::array<char, 4096> log{};
    glGetShaderInfoLog(shader.get(), static_cast<GLsizei>(log.size()), nullptr, log.data());
    throw refused(name, "compile", log.data());
}

GLint location(unsigned program, const char* uniform) {
    return glGetUniformLocation(program, uniform);
}

}  // namespace

void delete_program(unsigned name) { glDeleteProgram(name); }

Program::Program(const std::string& name, const std::vector<std::string_view>& sources,
                 const std::vector<std::string>& definitions)
    : name_(glCreateProgram()) {
    const Shader vertex =
        compile(name, GL_VERTEX_SHADER, full_source("LUMI_VERTEX", sources, definitions));
    const Shader fragment =
        compile(name, GL_FRAGMENT_SHADER, full_source("LUMI_FRAGMENT", sources, definitions));
    glAttachShader(name_.get(), vertex.get());
    glAttachShader(name_.get(), fragment.get());
    glLinkProgram(name_.get());
    GLint linked = GL_FALSE;
    glGetProgramiv(name_.get(), GL_LINK_STATUS, &linked);
    if (linked == GL_TRUE) return;
    std::array<char, 4096> log{};
    glGetProgramInfoLog(name_.get(), static_cast<GLsizei>(log.size()), nullptr, log.data());
    throw refused(name, "link", log.data());
}

void Program::use() const { glUseProgram(name_.get()); }

void Program::set(const char* uniform, int value) const {
    glUniform1i(location(name_.get(), uniform), value);
}

void Program::set(const char* uniform, float value) const {
    glUniform1f(location(name_.get(), uniform), value);
}

void Program::set(const char* uniform, const glm::vec2& value) const {
    glUniform2f(location(name_.get(), uniform), value.x, value.y);
}

void Program::set(const char* uniform, const glm::vec3& value) const {
    glUniform3f(location(name_.get(), uniform), value.x, value.y, value.z);
}

void Program::set(const char* uniform, const glm::vec4& value) const {
    glUniform4f(location(name_.get(), uniform), value.x, value.y, value.z, value.w);
}

void Program::set(const char* uniform, const glm::mat4& value) const {
    glUniformMatrix4fv(location(name_.get(), uniform), 1, GL_FALSE, glm::value_ptr(value));
}

void Program::set(const char* uniform, const std::vector<glm::vec4>& values) const {
    if (values.empty()) return;
    glUniform4fv(location(name_.get(), uniform), static_cast<GLsizei>(values.size()),
                 glm::value_ptr(values.front()));
}

}  // namespace lumi
