// Standard deviation of a time-of-flight camera's readings along its axis on a wall that faces it (Fankhauser et al.
// 2015), times 1.5. Metres.
float depth_sigma(float z) { return 0.0015 * (1.5 - 0.5 * z + 0.3 * z * z); }

// Two readings of the same surface differ by less than this.
float same_surface_gate(float z) { return 4.0 * depth_sigma(z) + 0.004; }
