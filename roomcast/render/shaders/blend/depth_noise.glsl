// How far readings of a time-of-flight camera scatter along its axis (Fankhauser et al. 2015, a wall that faces it),
// times 1.5. Metres.
float depth_sigma(float z) { return 0.0015 * (1.5 - 0.5 * z + 0.3 * z * z); }

// Two readings of the same surface differ by less.
float same_surface_gate(float z) { return 4.0 * depth_sigma(z) + 0.004; }
