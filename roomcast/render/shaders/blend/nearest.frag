layout(location = 0) out int drawn_by;

void main() { drawn_by = sensor; }
