// The numbers that several formulas share.

const float kPi = 3.14159265358979f;
const float kTwoPi = 6.28318530717959f;
