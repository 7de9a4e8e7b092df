@tool
extends RefCounted
## The power spectrum of a record.


## Returns the power of [param record] for the frequencies i·rate/count below half the rate. The
## number of samples is a power of two, with [param rate] samples per second. The sum of the powers
## times rate/count is the variance. The mean is subtracted, and a Hann window fades the ends out.
static func of(record: PackedFloat64Array, rate: float) -> PackedFloat64Array:
	var count := record.size()
	var mean := 0.0
	for value in record:
		mean += value / count
	var real := PackedFloat64Array()
	var imaginary := PackedFloat64Array()
	imaginary.resize(count)
	for i in count:
		real.append((record[i] - mean) * (0.5 - 0.5 * cos(TAU * i / count)))
	_transform(real, imaginary)
	var powers := PackedFloat64Array()
	var share := 2.0 / (rate * count * 0.375)  # Both halves of the spectrum; loss by the window.
	for i in count / 2:
		powers.append(share * (real[i] * real[i] + imaginary[i] * imaginary[i]))
	return powers


# Cooley and Tukey's algorithm, in place.
static func _transform(real: PackedFloat64Array, imaginary: PackedFloat64Array) -> void:
	var count := real.size()
	var j := 0
	for i in range(1, count):
		var bit := count >> 1
		while j & bit:
			j ^= bit
			bit >>= 1
		j |= bit
		if i < j:
			var kept := real[i]
			real[i] = real[j]
			real[j] = kept
			kept = imaginary[i]
			imaginary[i] = imaginary[j]
			imaginary[j] = kept
	var length := 2
	while length <= count:
		var half := length / 2
		for k in half:
			var turn := Vector2.from_angle(-TAU * k / length)
			for even in range(k, count, length):
				var odd := even + half
				var x := real[odd] * turn.x - imaginary[odd] * turn.y
				var y := real[odd] * turn.y + imaginary[odd] * turn.x
				real[odd] = real[even] - x
				imaginary[odd] = imaginary[even] - y
				real[even] += x
				imaginary[even] += y
		length *= 2
