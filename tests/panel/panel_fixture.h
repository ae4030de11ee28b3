#pragma once

#include "front_panel.h"
#include "manual_clock.h"

#include <initializer_list>
#include <memory>
#include <QObject>

namespace lds::test {

using emulator::Brightness;
using emulator::DisplayContent;
using emulator::IndicatorState;
using emulator::Key;
using emulator::ScreenKind;

/// A sensor with its front panel and a clock that the test drives; a person's hands at the keys.
class PanelFixture : public QObject {
protected:
    void setUp(catalog::SensorModel model = catalog::SensorModel::HlG203)
    {
        m_panel.reset();
        m_sensor.reset();
        m_clock = std::make_unique<emulator::ManualClock>();
        m_sensor = std::make_unique<emulator::VirtualSensor>(model, *m_clock);
        m_sensor->placeWorkpiece(0);
        m_panel = std::make_unique<emulator::FrontPanel>(*m_sensor, *m_clock);
        pass(200);
    }

    void pass(int milliseconds) { m_clock->advanceMs(milliseconds); }
    void press(Key key) { m_panel->keyPressed(key); }
    void release(Key key) { m_panel->keyReleased(key); }
    /// Down together for `milliseconds`, then up.
    void hold(std::initializer_list<Key> keys, int milliseconds)
    {
        for (const Key key : keys)
            press(key);
        pass(milliseconds);
        for (const Key key : keys)
            release(key);
    }
    void tap(Key key, int times = 1)
    {
        for (int i = 0; i < times; ++i)
            hold({key}, 50);
    }
    void tapTogether(Key first, Key second) { hold({first, second}, 50); }
    void holdLong(Key key) { hold({key}, 2000); }

    /// Into the setting mode, to the menu entry `number`: digit by digit, by what is shown.
    bool goToMenu(int number)
    {
        holdLong(Key::Enter);
        const QString digits = QString::number(number);
        for (qsizetype level = 1; level <= digits.size(); ++level) {
            const int wanted = digits.left(level).toInt();
            for (int i = 0; shown().menuNumber != wanted && i < 10; ++i)
                tap(Key::Down);
            if (shown().menuNumber != wanted)
                return false;
            if (level < digits.size())
                tap(Key::Enter);
        }
        return shown().screen == ScreenKind::Menu;
    }
    bool openMenu(int number)
    {
        const bool there = goToMenu(number);
        tap(Key::Enter);
        return there && shown().screen != ScreenKind::Menu;
    }
    /// Goes through the choices until `text` is shown.
    bool choose(const QString& text)
    {
        for (int i = 0; shown().body != text && i < 12; ++i)
            tap(Key::Down);
        return shown().body == text;
    }
    /// Turns the digits of an entry to `text` and stores it.
    void enter(const QString& text)
    {
        while (shown().screen == ScreenKind::Entry && shown().edited >= 0) {
            const int at = shown().edited;
            for (int i = 0; shown().body.at(at) != text.at(at) && i < 10; ++i)
                tap(Key::Up);
            const bool last = at + 1 == text.size();
            tap(Key::Enter);
            if (last)
                return;
        }
    }
    void leaveMenus()
    {
        for (int i = 0; shown().screen != ScreenKind::Measurement && i < 6; ++i)
            holdLong(Key::Enter);
    }

    DisplayContent shown() const { return m_panel->content(); }
    catalog::Value stored(catalog::ItemId item) const { return m_sensor->memory().value(item); }
    bool set(catalog::ItemId item, catalog::Value value) { return !m_sensor->write({{item, value}}).refusal; }
    /// A workpiece that has stood there for long, `value` 0.1 µm from the centre.
    void place(catalog::Value value)
    {
        m_sensor->placeWorkpiece(value);
        pass(emulator::FrontPanel::refreshMs);
    }

    std::unique_ptr<emulator::ManualClock> m_clock;
    std::unique_ptr<emulator::VirtualSensor> m_sensor;
    std::unique_ptr<emulator::FrontPanel> m_panel;
};

} // namespace lds::test
