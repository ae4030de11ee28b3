#pragma once

#include "key_gestures.h"
#include "panel_host.h"

#include <functional>
#include <QObject>

namespace lds::emulator {

/// One screen of the sensor. Screens lie on each other; the keys go to the one on top, the measurement
/// display lies at the bottom.
class PanelScreen : public QObject {
public:
    explicit PanelScreen(PanelHost& host)
        : m_host(host)
    {}

    /// Whether commands are still accepted while it is shown (§5.2.2 "on the measurement display").
    virtual bool keepsSensorReady() const { return false; }
    /// Came to the top: opened, or what lay on it was closed.
    virtual void shown() {}
    virtual void gesture(Gesture gesture) = 0;
    virtual void refresh() {} ///< About every 100 ms while on top.
    virtual void draw(DisplayContent& content) const = 0;

protected:
    PanelHost& host() const { return m_host; }
    VirtualSensor& sensor() const { return m_host.sensor(); }
    /// Runs `work` later, unless the screen is not on top then.
    void later(int delayMs, std::function<void()> work);

private:
    PanelHost& m_host;
};

inline constexpr int messageMs = 2000; ///< How long words stay that go away by themselves.

} // namespace lds::emulator
