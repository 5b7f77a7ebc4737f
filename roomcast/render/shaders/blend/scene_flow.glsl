// How what stands before a sensor's background moves (SurfaceFlow). Comes before the shaders that read it.

// In cells of kCellPixels x kCellPixels pixels: metres per second in the sensor's frame; surfaces nearer than the last
// number move, in metres.
layout(binding = 6) uniform sampler2D flow;

const int kCellPixels = 4;
