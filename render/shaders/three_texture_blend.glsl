// The measure of all frame times: the full screen, three photographs, weights that vary. No method
// that blends three views can be faster.

#ifdef LUMI_FRAGMENT
in vec2 position;  // 0 to 1 over the screen
uniform sampler2DArray photographs;
uniform vec2 photograph_share;  // of a layer that the photograph fills
out vec4 drawn;

void main() {
    vec3 weights = vec3(position.x, position.y, 1.0);
    weights /= weights.x + weights.y + weights.z;
    vec2 on_layer = position * photograph_share;
    drawn = vec4(weights.x * texture(photographs, vec3(on_layer, 0.0)).rgb +
                     weights.y * texture(photographs, vec3(on_layer, 1.0)).rgb +
                     weights.z * texture(photographs, vec3(on_layer, 2.0)).rgb,
                 1.0);
}
#endif
