#include "front_panel.h"

#include "item_screens.h"
#include "measurement_screen.h"
#include "message_screen.h"
#include "panel_text.h"
#include "sensor_view.h"

#include <algorithm>
#include <utility>

namespace lds::emulator {

using namespace catalog;
using namespace Qt::StringLiterals;

namespace {

/// Shown for two seconds after power-on (§3.6). The sensor works meanwhile.
class StartUpScreen final : public PanelScreen {
public:
    StartUpScreen(PanelHost& host, std::function<void()> then)
        : PanelScreen(host)
        , m_then(std::move(then))
    {}
    bool keepsSensorReady() const override { return true; }
    void shown() override { later(FrontPanel::startUpMs, m_then); }
    void gesture(Gesture) override {}
    void draw(DisplayContent& content) const override
    {
        content.screen = ScreenKind::StartUp;
        content.body = u"HL-G2"_s;
        content.note = QString::fromLatin1(Catalog::hlG2().model(sensor().model()).typeName);
    }

private:
    std::function<void()> m_then;
};

/// Locally administered, so that it belongs to no maker.
QByteArray virtualMacAddress() { return QByteArray::fromHex("020000000001"); }

} // namespace

FrontPanel::FrontPanel(VirtualSensor& sensor, EmulatorClock& clock, QObject* parent)
    : QObject(parent)
    , m_sensor(sensor)
    , m_clock(clock)
    , m_gestures(clock, [this](Gesture gesture) { onGesture(gesture); })
    , m_macAddress(virtualMacAddress())
    , m_lastKeyNs(clock.nowNs())
    , m_ecoMode(sensor.memory().value(ItemId::EcoMode))
{
    qRegisterMetaType<Key>();
    qRegisterMetaType<DisplayContent>();
    connect(&sensor, &VirtualSensor::poweredOn, this, &FrontPanel::powerOn);
    m_screens.push_back(std::make_unique<MeasurementScreen>(host()));
    m_content = draw();
    m_clock.after(refreshMs, this, [this] { tick(); });
}

FrontPanel::~FrontPanel() = default;

PanelLanguage FrontPanel::language() const
{
    return PanelLanguage(std::clamp<Value>(m_sensor.memory().value(ItemId::LanguageSetting), 0, 2));
}

// Keys

void FrontPanel::keyPressed(Key key)
{
    m_closed.clear();
    const bool asleep = isAsleep();
    wake();
    Key& meaning = m_meaning[std::size_t(key)];
    meaning = key;
    if (isInverted() && key != Key::Enter) // §4.8.3
        meaning = key == Key::Up ? Key::Down : Key::Up;
    m_gestures.press(meaning);
    if (asleep) // §4.8.2: the first one only brings the display back
        m_gestures.swallow();
    else if (isLocked())
        announce(words::keyLockOn); // §4.12.1
    update();
}

void FrontPanel::keyReleased(Key key)
{
    m_closed.clear();
    if (key == Key::Enter)
        m_enterSincePowerOn = false;
    m_lastKeyNs = m_clock.nowNs();
    m_gestures.release(m_meaning[std::size_t(key)]);
    update();
}

void FrontPanel::onGesture(Gesture gesture)
{
    m_sensor.catchUp();
    if (isLocked()) {
        if (gesture == Gesture::HoldUpDown)
            setLock(false);
    } else if (!m_sensor.procedureByCommunication()) { // §4.3.3, §4.9
        if (m_announcement)
            announce(nullptr);
        m_screens.back()->gesture(gesture);
    }
    update();
}

bool FrontPanel::isLocked() const { return m_sensor.memory().value(ItemId::KeyLock) != 0; }

void FrontPanel::lockKeys() { setLock(true); }

void FrontPanel::setLock(bool on)
{
    if (!m_sensor.writeByKeys({{ItemId::KeyLock, on}}).refusal)
        announce(on ? words::keyLockOn : words::keyLockOff);
}

/// Words over the screen, which stays; nothing takes them away.
void FrontPanel::announce(const char* english)
{
    m_announcement = english;
    m_clock.cancel(m_announcementTimer);
    m_announcementTimer = 0;
    if (!english)
        return;
    m_announcementTimer = m_clock.after(keyLockMessageMs, this, [this] {
        m_announcementTimer = 0;
        m_announcement = nullptr;
        update();
    });
}

// Screens

void FrontPanel::open(std::unique_ptr<PanelScreen> screen)
{
    m_screens.push_back(std::move(screen));
    showTop();
}

void FrontPanel::close()
{
    if (m_screens.size() == 1)
        return;
    popTop();
    showTop();
}

void FrontPanel::closeAll()
{
    while (m_screens.size() > 1)
        popTop();
    showTop();
}

/// What is closed may be the one that is asking: it goes later.
void FrontPanel::popTop()
{
    m_closed.push_back(std::move(m_screens.back()));
    m_screens.pop_back();
}

void FrontPanel::showTop()
{
    m_screens.back()->shown();
    const bool inMenu = !m_screens.back()->keepsSensorReady();
    if (inMenu != m_inMenu)
        m_sensor.setInMenu(inMenu);
    m_inMenu = inMenu;
}

bool FrontPanel::isOnTop(const PanelScreen* screen) const { return m_screens.back().get() == screen; }

void FrontPanel::changed() { update(); }

void FrontPanel::leave()
{
    m_gestures.swallow();
    if (m_sensor.teaching().isExecuting() && m_sensor.teaching().operatedBy() == Operator::Keys)
        m_sensor.interruptTeaching();
    if (m_sensor.tuning().isExecuting() && m_sensor.tuning().operatedBy() == Operator::Keys)
        m_sensor.interruptTuning();
    closeAll();
    update();
}

void FrontPanel::tell() { Q_EMIT contentChanged(m_content); }

// Power

void FrontPanel::powerOn()
{
    if (m_initializing) // it switches the power itself
        return;
    m_inMenu = false;
    m_gestures.swallow();
    m_enterSincePowerOn = m_gestures.isHeld(Key::Enter);
    announce(nullptr);
    m_lastKeyNs = m_clock.nowNs();
    while (m_screens.size() > 1)
        popTop();
    m_sensor.setInMenu(false);
    open(std::make_unique<StartUpScreen>(host(), [this] { finishStartUp(); }));
    update();
}

void FrontPanel::finishStartUp()
{
    if (m_enterSincePowerOn)
        initializeSetValues();
    else
        close();
}

/// §4.8.6 "Set value initialization": ENTER was held for two seconds from power-on.
void FrontPanel::initializeSetValues()
{
    m_initializing = true;
    m_sensor.initializeSetValues();
    m_initializing = false;
    m_inMenu = false; // as after power-on
    popTop();
    open(std::make_unique<MessageScreen>(host(), words::initializing,
                                         [this] { open(initialLanguageScreen(*this)); }));
}

// Display

void FrontPanel::tick()
{
    m_clock.after(refreshMs, this, [this] { tick(); });
    m_closed.clear();
    m_sensor.catchUp();
    // §4.8.2: no command brings the brightness back but a change of the eco mode itself.
    const Value ecoMode = m_sensor.memory().value(ItemId::EcoMode);
    if (std::exchange(m_ecoMode, ecoMode) != ecoMode)
        wake();
    m_screens.back()->refresh();
    update();
}

void FrontPanel::update()
{
    DisplayContent content = draw();
    if (content == m_content)
        return;
    m_content = std::move(content);
    Q_EMIT contentChanged(m_content);
}

DisplayContent FrontPanel::draw() const
{
    DisplayContent content;
    content.language = language();
    content.inverted = isInverted();
    content.brightness = brightness();
    content.laserIndicator = laserIndicator(m_sensor);
    content.alarmIndicator = alarmIndicator(m_sensor);
    if (m_announcement) {
        content.screen = ScreenKind::Message;
        content.body = text(m_announcement);
    } else {
        m_screens.back()->draw(content);
    }
    return content;
}

bool FrontPanel::isInverted() const { return m_sensor.memory().value(ItemId::DisplayInversion) != 0; }

qint64 FrontPanel::idleMs() const { return (m_clock.nowNs() - m_lastKeyNs) / 1'000'000; }

/// A key that is held is being operated.
bool FrontPanel::isAsleep() const { return !m_gestures.anyHeld() && idleMs() >= untilEcoMs; }

void FrontPanel::wake() { m_lastKeyNs = m_clock.nowNs(); }

/// §4.8.2
Brightness FrontPanel::brightness() const
{
    if (!isAsleep())
        return Brightness::Normal;
    if (m_sensor.memory().value(ItemId::EcoMode) != 0)
        return Brightness::Off;
    const qint64 phase = (idleMs() - untilEcoMs) % ecoBlinkPeriodMs;
    return phase >= ecoBlinkPeriodMs - ecoBlinkMs ? Brightness::Blink : Brightness::Dim;
}

} // namespace lds::emulator
