// The corners of triangles on which photographs are blended (blend_triangles.h), as vertex buffers
// hold them (blend_vertex_attributes).

#ifdef LUMI_VERTEX
uniform mat4 clip_from_eye_pixel;
uniform vec2 layer_size;
layout(location = 0) in vec3 in_pixel_and_depth;
layout(location = 1) in vec4 in_view_pixels01;
layout(location = 2) in vec2 in_view_pixel2;
layout(location = 3) in vec3 in_weights;
layout(location = 4) in vec3 in_inverse_depth_and_confidence;
layout(location = 5) in vec4 in_layers_and_face;
layout(location = 6) in vec3 in_depth_ratios;
layout(location = 7) in vec4 in_opacity_and_surroundings;
#endif
