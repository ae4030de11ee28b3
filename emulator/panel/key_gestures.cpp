#include "key_gestures.h"

#include <algorithm>
#include <optional>

namespace lds::emulator {

namespace {

constexpr std::array<bool, keyCount> justUp{true, false, false};
constexpr std::array<bool, keyCount> justEnter{false, true, false};
constexpr std::array<bool, keyCount> justDown{false, false, true};
constexpr std::array<bool, keyCount> upAndDown{true, false, true};
constexpr std::array<bool, keyCount> downAndEnter{false, true, true};
constexpr std::array<bool, keyCount> upAndEnter{true, true, false};

std::optional<Gesture> heldGesture(const std::array<bool, keyCount>& keys)
{
    if (keys == justUp)
        return Gesture::HoldUp;
    if (keys == justEnter)
        return Gesture::HoldEnter;
    if (keys == justDown)
        return Gesture::HoldDown;
    if (keys == upAndDown)
        return Gesture::HoldUpDown;
    return {};
}

std::optional<Gesture> releasedGesture(const std::array<bool, keyCount>& keys)
{
    if (keys == justUp)
        return Gesture::Up;
    if (keys == justEnter)
        return Gesture::Enter;
    if (keys == justDown)
        return Gesture::Down;
    if (keys == upAndDown)
        return Gesture::UpDown;
    return {};
}

} // namespace

KeyGestures::KeyGestures(EmulatorClock& clock, std::function<void(Gesture)> done, QObject* parent)
    : QObject(parent)
    , m_clock(clock)
    , m_done(std::move(done))
{}

void KeyGestures::press(Key key)
{
    if (isHeld(key))
        return;
    m_held[std::size_t(key)] = true;
    m_together[std::size_t(key)] = true;
    stopWaiting();
    if (m_swallowed)
        return;
    if (m_held == downAndEnter)
        finish(Gesture::DownEnter);
    else if (m_held == upAndEnter)
        finish(Gesture::UpEnter);
    else if (const auto gesture = heldGesture(m_held))
        waitFor(*gesture);
    else
        m_swallowed = true; // all three: nothing
}

void KeyGestures::release(Key key)
{
    if (!isHeld(key))
        return;
    m_held[std::size_t(key)] = false;
    stopWaiting();
    const auto gesture = m_swallowed ? std::nullopt : releasedGesture(m_together);
    m_swallowed = anyHeld();
    if (!anyHeld())
        m_together = {};
    if (gesture)
        m_done(*gesture);
}

void KeyGestures::swallow()
{
    stopWaiting();
    m_swallowed = anyHeld();
}

void KeyGestures::finish(Gesture gesture)
{
    m_swallowed = true;
    m_done(gesture);
}

void KeyGestures::waitFor(Gesture gesture)
{
    m_timer = m_clock.after(holdMs, this, [this, gesture] {
        m_timer = 0;
        finish(gesture);
    });
}

void KeyGestures::stopWaiting()
{
    if (m_timer)
        m_clock.cancel(m_timer);
    m_timer = 0;
}

} // namespace lds::emulator
