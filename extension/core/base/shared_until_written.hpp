#pragma once

#include <memory>

namespace undergrowth {

/// A value that copies share until one of them is written to, which then has one of its own. Copies may go to other
/// threads and die there: whether a value is shared is noted when it is copied, and never asked of how many still hold
/// it, since another thread may not have seen the last of what it read by then. Copying writes that note into what is
/// copied from, so one object is for one thread at a time, as long as any is copied.
template <class Value> class SharedUntilWritten {
public:
	SharedUntilWritten() : value(std::make_shared<Value>()) {}
	SharedUntilWritten(const SharedUntilWritten &other) : value(other.value), is_shared(true) {
		other.is_shared = true;
	}
	SharedUntilWritten &operator=(const SharedUntilWritten &other) {
		value = other.value;
		is_shared = other.is_shared = true;
		return *this;
	}
	/// What is moved from may only be assigned to or die.
	SharedUntilWritten(SharedUntilWritten &&) noexcept = default;
	SharedUntilWritten &operator=(SharedUntilWritten &&) noexcept = default;
	~SharedUntilWritten() = default;

	const Value &operator*() const { return *value; }
	const Value *operator->() const { return value.get(); }

	/// To be written to: no copy sees it.
	Value &own() {
		if (is_shared) {
			value = std::make_shared<Value>(*value);
			is_shared = false;
		}
		return *value;
	}

private:
	std::shared_ptr<Value> value;
	mutable bool is_shared = false;
};

} // namespace undergrowth
