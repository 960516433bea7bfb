// How a sculpture's values are stored (sculpt::Precision): SCULPTURE_BITS is 8, 16 or 32; SCULPTURE_FORMAT is
// its image format.

#ifndef SCULPTURE_BITS
#error "SCULPTURE_BITS is not defined: give the program sculpt::storedDefines()"
#endif

#if SCULPTURE_BITS == 8
#define SCULPTURE_FORMAT r8
#elif SCULPTURE_BITS == 16
#define SCULPTURE_FORMAT r16f
#else
#define SCULPTURE_FORMAT r32f
#endif

// A value as it is stored, so that what is counted as changed is what changes. Energies that would be stored
// as 0, or in floats are below half a step of 16 bits at 1, are no more than the Gaussian's cut-off and
// rounding. justVisible is sculpt::justVisible().
#if SCULPTURE_BITS == 8
const float negligible = 0.5 / 255.0;
const float justVisible = 127.0 / 255.0;
float asStored(float value) { return floor(value * 255.0 + 0.5) / 255.0; }
bool differ(float a, float b) { return abs(a - b) > 0.25 / 255.0; }
#elif SCULPTURE_BITS == 16
const float negligible = 1.0 / 2048.0;
const float justVisible = 0.499755859375;
// The nearest number of 11 binary digits, the even one of two. Whole numbers find it: a driver may leave out
// a packing that is unpacked at once, and images may cut off what they cannot hold.
float asStored(float value) {
    uint bits = floatBitsToUint(value);
    float rounded = uintBitsToFloat((bits + 0x0FFFu + ((bits >> 13) & 1u)) & ~0x1FFFu);
    return value < 1.0 / 16384.0 ? roundEven(value * 16777216.0) / 16777216.0 : rounded;
}
bool differ(float a, float b) { return a != b; }
#else
const float negligible = 1.0 / 2048.0;
const float justVisible = 0.49999997;
float asStored(float value) { return value; }
bool differ(float a, float b) { return a != b; }
#endif
