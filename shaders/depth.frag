// Of what only its depth is drawn (render/surface/depth_pass.h).
void main() {}
