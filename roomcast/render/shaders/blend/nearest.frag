layout(location = 4) uniform int sensor;

layout(location = 1) out int drawn_by;

void main() { drawn_by = sensor; }
