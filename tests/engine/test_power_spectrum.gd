## The spectrum in the dock: records of known frequencies, and the air.
extends "res://tests/engine/harness.gd"

const PowerSpectrum := preload("res://addons/undergrowth/editor/widgets/power_spectrum.gd")
const COUNT := 1024
const RATE := 16.0
## Of the variance, with a window that fades out the ends.
const TOLERANCE := 0.02
## Ratio to Kaimal's line in bands of an octave, with records as long as the dock's.
const BAND_TOLERANCE := 0.25


func test_a_sine_appears_at_its_frequency_with_its_variance() -> void:
	var powers := PowerSpectrum.of(_sine(2.0, 3.0, 5.0), RATE)
	check_equal(powers.size(), COUNT / 2, "frequencies")
	var step := RATE / COUNT
	var near := 0.0
	var all := 0.0
	for i in powers.size():
		all += powers[i] * step
		near += powers[i] * step if absf(i * step - 2.0) < 2.5 * step else 0.0
	check_near(all, 4.5, TOLERANCE * 4.5, "variance")
	check_near(near, 4.5, TOLERANCE * 4.5, "variance near 2 Hz")


func test_two_sines_share_the_variance() -> void:
	var record := _sine(1.0, 2.0, 0.0)
	var other := _sine(4.0, 1.0, 0.0)
	for i in COUNT:
		record[i] += other[i]
	var powers := PowerSpectrum.of(record, RATE)
	var step := RATE / COUNT
	var slow := 0.0
	for i in powers.size():
		slow += powers[i] * step if i * step < 2.0 else 0.0
	check_near(slow, 2.0, TOLERANCE * 2.0, "variance below 2 Hz")


func test_air_has_the_spectrum_that_was_measured_over_a_field() -> void:
	var wind := PlantWind.new()
	wind.kind = PlantWind.KIND_AIR
	wind.gustiness = 0.0
	var records := 24
	var powers := PackedFloat64Array()
	powers.resize(COUNT / 2)
	var sums := Vector2.ZERO
	for record in records:
		var speeds := PackedFloat64Array()
		for i in COUNT:
			var time := (record * COUNT + i) / RATE
			speeds.append(wind.sample_velocity(time, Vector3.UP).z)
			sums += Vector2(speeds[i], speeds[i] * speeds[i]) / (records * COUNT)
		var own := PowerSpectrum.of(speeds, RATE)
		for i in own.size():
			powers[i] += own[i] / records
	var variance := sums.y - sums.x * sums.x
	for low: float in [0.125, 0.25, 0.5, 1.0, 2.0]:
		var measured := 0.0
		var expected := 0.0
		for i in range(ceili(low * COUNT / RATE), floori(2.0 * low * COUNT / RATE)):
			measured += powers[i] / variance
			expected += _kaimal(wind, i * RATE / COUNT)
		var reported := "from %.3f Hz" % low
		check_near(measured / expected, 1.0, BAND_TOLERANCE, reported)


func _kaimal(wind: PlantWind, hertz: float) -> float:
	var carried := wind.speed * log(1.0 / wind.roughness) / log(10.0 / wind.roughness)
	var f := hertz / carried
	return 105.0 * f / pow(1.0 + 33.0 * f, 5.0 / 3.0) / (2.185 * 2.185) / hertz


func _sine(hertz: float, amplitude: float, mean: float) -> PackedFloat64Array:
	var record := PackedFloat64Array()
	for i in COUNT:
		record.append(mean + amplitude * sin(TAU * hertz * i / RATE))
	return record
