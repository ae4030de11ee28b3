#pragma once

#include "key_gestures.h"
#include "panel_host.h"
#include "panel_screen.h"

#include <array>
#include <memory>
#include <QObject>
#include <vector>

namespace lds::emulator {

/// The display and the three keys of a virtual sensor: chapter 4 of the manual as a person sees it. Lives in
/// the sensor's thread; a widget elsewhere is connected by queued signals. It follows the sensor about ten
/// times a second by the sensor's clock.
///
/// While a screen other than the measurement display and the received light is shown, the sensor is not
/// ready for commands (§5.2.2).
class FrontPanel final : public QObject, private PanelHost {
    Q_OBJECT

public:
    static constexpr int refreshMs = 100;
    static constexpr int startUpMs = 2000;            ///< §3.6
    static constexpr int initializingMs = 2000;       ///< §4.8.6
    static constexpr int keyLockMessageMs = 2000;     ///< §4.12
    static constexpr qint64 untilEcoMs = 180'000;     ///< §4.8.2
    static constexpr qint64 ecoBlinkPeriodMs = 5'000; ///< §4.8.2
    static constexpr qint64 ecoBlinkMs = 300;

    /// Shows the measurement display at once, as of a sensor that has been running. `sensor` and `clock`
    /// must outlive it.
    FrontPanel(VirtualSensor& sensor, EmulatorClock& clock, QObject* parent = nullptr);
    ~FrontPanel() override;

    DisplayContent content() const { return m_content; }
    /// What menu 78 shows; six bytes. A locally administered address unless told.
    void setMacAddress(const QByteArray& address) { m_macAddress = address; }

public Q_SLOTS:
    void keyPressed(lds::emulator::Key key);
    void keyReleased(lds::emulator::Key key);
    /// The power has just come on: the start-up screen. Called by itself after a power cycle of the sensor.
    void powerOn();
    /// Breaks off whatever is being done and shows the measurement display, for who goes away from the keys.
    void leave();
    /// Tells its content again, for who has just begun to listen.
    void tell();

Q_SIGNALS:
    void contentChanged(const lds::emulator::DisplayContent& content);

private:
    // PanelHost
    VirtualSensor& sensor() override { return m_sensor; }
    EmulatorClock& clock() override { return m_clock; }
    PanelLanguage language() const override;
    QByteArray macAddress() const override { return m_macAddress; }
    void open(std::unique_ptr<PanelScreen> screen) override;
    void close() override;
    void closeAll() override;
    void lockKeys() override;
    bool isOnTop(const PanelScreen* screen) const override;
    void changed() override;

    PanelHost& host() { return *this; }
    void tick();
    void update();
    DisplayContent draw() const;
    Brightness brightness() const;
    void onGesture(Gesture gesture);
    void setLock(bool on);
    void announce(const char* english);
    void finishStartUp();
    void initializeSetValues();
    void popTop();
    void showTop();
    bool isLocked() const;
    bool isInverted() const;
    bool isAsleep() const;
    void wake();
    qint64 idleMs() const;

    VirtualSensor& m_sensor;
    EmulatorClock& m_clock;
    KeyGestures m_gestures;
    std::array<Key, keyCount> m_meaning{Key::Up, Key::Enter, Key::Down}; ///< Of each key while it is down.
    std::vector<std::unique_ptr<PanelScreen>> m_screens;                 ///< The last is on top.
    std::vector<std::unique_ptr<PanelScreen>> m_closed; ///< Until nothing of them runs any more.
    DisplayContent m_content;
    const char* m_announcement = nullptr; ///< "KEY LOCK ON" over whatever is shown.
    EmulatorClock::TimerId m_announcementTimer = 0;
    QByteArray m_macAddress;
    qint64 m_lastKeyNs;
    catalog::Value m_ecoMode;
    bool m_enterSincePowerOn = false;
    bool m_initializing = false;
    bool m_inMenu = false;
};

} // namespace lds::emulator
