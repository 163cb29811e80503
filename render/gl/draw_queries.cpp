#include "render/gl/draw_queries.h"

#include <epoxy/gl.h>

#include "render/gl/capabilities.h"
#include "render/gl/object_name.h"

namespace lumi {
namespace {

/// Since the thread began.
thread_local std::uint64_t all_uploaded_bytes = 0;

void delete_query(unsigned name) { glDeleteQueries(1, &name); }

ObjectName<delete_query> new_query() {
    GLuint name = 0;
    glGenQueries(1, &name);
    return ObjectName<delete_query>(name);
}

/// What a query of this kind tells of a drawing; waits until it is drawn.
std::uint64_t told_by(GLenum kind, const std::function<void()>& draw) {
    const ObjectName<delete_query> query = new_query();
    glBeginQuery(kind, query.get());
    draw();
    glEndQuery(kind);
    GLuint64 result = 0;
    glGetQueryObjectui64v(query.get(), GL_QUERY_RESULT, &result);
    return result;
}

}  // namespace

std::optional<std::uint64_t> fragment_count(const std::function<void()>& draw) {
    if (!epoxy_is_desktop_gl()) return std::nullopt;
    return told_by(GL_SAMPLES_PASSED, draw);
}

std::uint64_t uploaded_bytes(const std::function<void()>& draw) {
    const std::uint64_t before = all_uploaded_bytes;
    draw();
    return all_uploaded_bytes - before;
}

void count_uploaded(std::size_t bytes) { all_uploaded_bytes += bytes; }

std::optional<double> device_time_ms(const std::function<void()>& draw) {
    if (!epoxy_is_desktop_gl() || query_capabilities().works_on_cpu) return std::nullopt;
    constexpr double kMillisecondsPerNanosecond = 1e-6;
    return kMillisecondsPerNanosecond * static_cast<double>(told_by(GL_TIME_ELAPSED, draw));
}

}  // namespace lumi
