#include "render/gl/lookup_meter.h"

#include <epoxy/gl.h>

#include <cassert>

#include "render/gl/object_name.h"
#include "render/gl/vertex_buffer.h"

namespace lumi {
namespace {

thread_local bool a_meter_lives = false;

bool can_count() { return epoxy_is_desktop_gl() && epoxy_gl_version() >= 42; }

// In the macros' own text the names are those of the functions.
constexpr const char* kCountingSource =
    "#extension GL_ARB_shader_atomic_counters : require\n"
    "layout(binding = 0, offset = 0) uniform atomic_uint lookups;\n"
    "#define texture(s, p) (atomicCounterIncrement(lookups), texture(s, p))\n"
    "#define textureLod(s, p, l) (atomicCounterIncrement(lookups), textureLod(s, p, l))\n"
    "#define texelFetch(s, p, l) (atomicCounterIncrement(lookups), texelFetch(s, p, l))\n";

ObjectName<delete_buffer> new_counter() {
    GLuint name = 0;
    glGenBuffers(1, &name);
    return ObjectName<delete_buffer>(name);
}

}  // namespace

LookupMeter::LookupMeter() {
    assert(!a_meter_lives);
    a_meter_lives = true;
}

LookupMeter::~LookupMeter() { a_meter_lives = false; }

std::optional<std::uint64_t> LookupMeter::lookups(const std::function<void()>& draw) const {
    if (!can_count()) return std::nullopt;
    const ObjectName<delete_buffer> counter = new_counter();
    GLuint count = 0;
    glBindBufferBase(GL_ATOMIC_COUNTER_BUFFER, 0, counter.get());
    glBufferData(GL_ATOMIC_COUNTER_BUFFER, sizeof(count), &count, GL_DYNAMIC_READ);
    draw();
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glBindBuffer(GL_ATOMIC_COUNTER_BUFFER, counter.get());
    glGetBufferSubData(GL_ATOMIC_COUNTER_BUFFER, 0, sizeof(count), &count);
    glBindBufferBase(GL_ATOMIC_COUNTER_BUFFER, 0, 0);
    return count;
}

std::string lookup_counting_source() {
    return a_meter_lives && can_count() ? kCountingSource : std::string();
}

}  // namespace lumi
