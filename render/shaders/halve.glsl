// Each pixel becomes the mean of four of a picture that is twice as wide and high. Not left to a
// scaling blit, as drivers may round each of its steps up.

#ifdef LUMI_FRAGMENT
uniform sampler2DArray picture;
out vec4 drawn;

void main() {
    ivec3 at = ivec3(2 * ivec2(gl_FragCoord.xy), 0);
    drawn = 0.25 * (texelFetch(picture, at, 0) + texelFetch(picture, at + ivec3(1, 0, 0), 0) +
                    texelFetch(picture, at + ivec3(0, 1, 0), 0) +
                    texelFetch(picture, at + ivec3(1, 1, 0), 0));
}
#endif
