// A table or a message without the digits of round-off, which no two compilers have in common: of moments that vanish, and of the condition
// of a system that is singular.
exports.withoutRoundOff = (text) => text.replace(/: [-+.e\d]+, as it must be/g, ": as it must be").replace(/reciprocal condition [-+.e\d]+/g, "reciprocal condition");
