#include "display_view.h"
#include "indicator_lamp.h"
#include "key_button.h"
#include "panel_fixture.h"
#include "panel_widget.h"

#include <QAbstractButton>
#include <QAccessible>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

using namespace lds;
using namespace lds::test;
using namespace Qt::StringLiterals;
using emulator::KeyButton;
using emulator::PanelWidget;

namespace {

/// "+Up -Up": what the widget told of its keys.
struct KeyLog : QObject {
    explicit KeyLog(PanelWidget& widget)
    {
        connect(&widget, &PanelWidget::keyPressed, this, [this](Key key) { add(u'+', key); });
        connect(&widget, &PanelWidget::keyReleased, this, [this](Key key) { add(u'-', key); });
    }
    void add(QChar what, Key key)
    {
        static const QStringList names{u"Up"_s, u"Enter"_s, u"Down"_s};
        told += what + names[int(key)];
    }
    QString take()
    {
        const QString text = told.join(u' ');
        told.clear();
        return text;
    }
    QStringList told;
};

} // namespace

/// The widget of the front panel under real mouse and keyboard events.
class TestPanelWidget : public PanelFixture {
    Q_OBJECT

private:
    static KeyButton* key(const PanelWidget& widget, const QString& name)
    {
        const auto buttons = widget.findChildren<KeyButton*>();
        for (KeyButton* button : buttons) {
            if (button->text() == name)
                return button;
        }
        return nullptr;
    }
    static void showUp(PanelWidget& widget)
    {
        widget.QWidget::show();
        widget.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&widget));
        widget.setFocus();
    }
    static DisplayContent inverted()
    {
        DisplayContent content;
        content.inverted = true;
        return content;
    }

private Q_SLOTS:
    void init() { setUp(); }

    void the_mouse_presses_and_lets_go_of_a_key()
    {
        PanelWidget widget;
        showUp(widget);
        KeyLog log(widget);
        for (const auto& [name, expected] : {std::pair(u"UP"_s, u"+Up -Up"_s),
                                             {u"ENTER"_s, u"+Enter -Enter"_s},
                                             {u"DOWN"_s, u"+Down -Down"_s}}) {
            QTest::mousePress(key(widget, name), Qt::LeftButton);
            QVERIFY(!log.told.isEmpty() && log.told.size() == 1);
            QTest::mouseRelease(key(widget, name), Qt::LeftButton);
            QCOMPARE(log.take(), expected);
        }
    }

    void a_right_click_keeps_a_key_pressed_until_the_next()
    {
        PanelWidget widget;
        showUp(widget);
        KeyLog log(widget);
        QTest::mouseClick(key(widget, u"ENTER"_s), Qt::RightButton);
        QCOMPARE(log.take(), u"+Enter"_s);
        QVERIFY(key(widget, u"ENTER"_s)->isLatched());
        QTest::mouseClick(key(widget, u"DOWN"_s), Qt::LeftButton); // two at once with one mouse
        QCOMPARE(log.take(), u"+Down -Down"_s);
        QTest::mouseClick(key(widget, u"ENTER"_s), Qt::RightButton);
        QCOMPARE(log.take(), u"-Enter"_s);
    }

    void a_button_holds_two_keys_together_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("pressed");
        QTest::addColumn<QString>("released");
        QTest::newRow("UP+DOWN") << u"UP+DOWN"_s << u"+Up +Down"_s << u"-Up -Down"_s;
        QTest::newRow("DOWN+ENTER") << u"DOWN+ENTER"_s << u"+Down +Enter"_s << u"-Down -Enter"_s;
        QTest::newRow("UP+ENTER") << u"UP+ENTER"_s << u"+Up +Enter"_s << u"-Up -Enter"_s;
    }
    void a_button_holds_two_keys_together()
    {
        QFETCH(QString, name);
        QFETCH(QString, pressed);
        QFETCH(QString, released);
        PanelWidget widget;
        showUp(widget);
        KeyLog log(widget);
        auto* button = widget.findChild<QToolButton*>(name);
        QVERIFY(button);
        QTest::mousePress(button, Qt::LeftButton);
        QCOMPARE(log.take(), pressed);
        QTest::mouseRelease(button, Qt::LeftButton);
        QCOMPARE(log.take(), released);
    }

    void the_keyboard_presses_several_keys_at_once()
    {
        PanelWidget widget;
        showUp(widget);
        KeyLog log(widget);
        QTest::keyPress(&widget, Qt::Key_Up);
        QTest::keyPress(&widget, Qt::Key_Down);
        QCOMPARE(log.take(), u"+Up +Down"_s);
        QTest::keyRelease(&widget, Qt::Key_Up);
        QTest::keyRelease(&widget, Qt::Key_Down);
        QCOMPARE(log.take(), u"-Up -Down"_s);
        QTest::keyClick(&widget, Qt::Key_Return);
        QTest::keyClick(&widget, Qt::Key_Enter, Qt::KeypadModifier);
        QCOMPARE(log.take(), u"+Enter -Enter +Enter -Enter"_s);
    }

    void keys_that_repeat_themselves_are_one_press()
    {
        PanelWidget widget;
        showUp(widget);
        KeyLog log(widget);
        QTest::keyPress(&widget, Qt::Key_Up);
        for (int i = 0; i < 3; ++i) {
            QKeyEvent up(QEvent::KeyRelease, Qt::Key_Up, Qt::NoModifier, {}, true);
            QKeyEvent down(QEvent::KeyPress, Qt::Key_Up, Qt::NoModifier, {}, true);
            QCoreApplication::sendEvent(&widget, &up);
            QCoreApplication::sendEvent(&widget, &down);
        }
        QTest::keyRelease(&widget, Qt::Key_Up);
        QCOMPARE(log.take(), u"+Up -Up"_s);
    }

    void other_keys_are_left_to_others()
    {
        PanelWidget widget;
        showUp(widget);
        KeyLog log(widget);
        QTest::keyClick(&widget, Qt::Key_A);
        QKeyEvent event(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier);
        QCoreApplication::sendEvent(&widget, &event);
        QVERIFY(!event.isAccepted());
        QVERIFY(log.told.isEmpty());
    }

    void the_sensor_keys_work_while_a_button_has_the_focus()
    {
        PanelWidget widget;
        showUp(widget);
        KeyLog log(widget);
        key(widget, u"DOWN"_s)->setFocus(Qt::TabFocusReason);
        QTest::keyClick(key(widget, u"DOWN"_s), Qt::Key_Up);
        QCOMPARE(log.take(), u"+Up -Up"_s);
        QVERIFY(key(widget, u"DOWN"_s)->hasFocus());
        QTest::keyClick(key(widget, u"DOWN"_s), Qt::Key_Space);
        QCOMPARE(log.take(), u"+Down -Down"_s);
    }

    void one_key_held_twice_is_told_once()
    {
        PanelWidget widget;
        showUp(widget);
        KeyLog log(widget);
        QTest::mouseClick(key(widget, u"UP"_s), Qt::RightButton);
        QTest::keyPress(&widget, Qt::Key_Up);
        QTest::keyRelease(&widget, Qt::Key_Up);
        QTest::mouseClick(key(widget, u"UP"_s), Qt::RightButton);
        QCOMPARE(log.take(), u"+Up -Up"_s);
    }

    void nothing_stays_pressed_when_the_focus_or_the_widget_goes_away()
    {
        PanelWidget widget;
        showUp(widget);
        KeyLog log(widget);
        QTest::keyPress(&widget, Qt::Key_Down);
        widget.clearFocus();
        QCOMPARE(log.take(), u"+Down -Down"_s);
        QTest::mouseClick(key(widget, u"ENTER"_s), Qt::RightButton);
        widget.hide();
        QCOMPARE(log.take(), u"+Enter -Enter"_s);
    }

    /// §4.8.3: "When the display is inverted, the positions of the UP and DOWN keys are swapped."
    void an_inverted_display_swaps_the_names_of_the_keys()
    {
        PanelWidget widget;
        showUp(widget);
        KeyLog log(widget);
        const KeyButton* left = key(widget, u"UP"_s);
        widget.showContent(inverted());
        QCOMPARE(left->text(), u"DOWN"_s);
        QCOMPARE(left->accessibleName(), u"DOWN key"_s);
        QTest::mouseClick(key(widget, u"UP"_s), Qt::LeftButton);
        QCOMPARE(log.take(), u"+Down -Down"_s); // the place that is now called UP
        QTest::keyClick(&widget, Qt::Key_Up);
        QCOMPARE(log.take(), u"+Down -Down"_s);
        QTest::mouseClick(widget.findChild<QToolButton*>(u"UP+ENTER"_s), Qt::LeftButton);
        QCOMPARE(log.take(), u"+Down +Enter -Down -Enter"_s);
    }

    void a_key_is_let_go_where_it_was_pressed()
    {
        PanelWidget widget;
        showUp(widget);
        KeyLog log(widget);
        QTest::keyPress(&widget, Qt::Key_Up);
        widget.showContent(inverted());
        QTest::keyRelease(&widget, Qt::Key_Up);
        QCOMPARE(log.take(), u"+Up -Up"_s);
    }

    void everything_has_a_name_to_be_read_aloud()
    {
        PanelWidget widget;
        widget.showContent(shown());
        QCOMPARE(widget.accessibleName(), u"Sensor front panel"_s);
        const auto buttons = widget.findChildren<QAbstractButton*>();
        QCOMPARE(buttons.size(), 7);
        for (const QAbstractButton* button : buttons) {
            QVERIFY2(!button->accessibleName().isEmpty(), qPrintable(button->text()));
            QVERIFY2(!button->toolTip().isEmpty(), qPrintable(button->text()));
        }
        const auto* display = widget.findChild<emulator::DisplayView*>();
        QCOMPARE(display->accessibleName(), u"Sensor display"_s);
        QCOMPARE(display->accessibleDescription(), u"+0.0000 mm, LASER, GO, B1"_s);
        QStringList lamps;
        const auto indicators = widget.findChildren<emulator::IndicatorLamp*>();
        for (const auto* lamp : indicators)
            lamps += lamp->accessibleName() + u": "_s + lamp->accessibleDescription();
        QCOMPARE(lamps, (QStringList{u"Laser radiation indicator: lit"_s, u"Alarm indicator: off"_s}));
    }

    void the_power_button_asks_for_a_power_cycle()
    {
        PanelWidget widget;
        showUp(widget);
        QSignalSpy asked(&widget, &PanelWidget::powerCycleRequested);
        QTest::mouseClick(widget.findChild<QAbstractButton*>(u"power"_s), Qt::LeftButton);
        QCOMPARE(asked.size(), 1);
    }

    /// From the mouse through the panel's state machine to the drawing and back.
    void the_widget_drives_a_front_panel()
    {
        PanelWidget widget;
        showUp(widget);
        connect(&widget, &PanelWidget::keyPressed, m_panel.get(), &emulator::FrontPanel::keyPressed);
        connect(&widget, &PanelWidget::keyReleased, m_panel.get(), &emulator::FrontPanel::keyReleased);
        connect(m_panel.get(), &emulator::FrontPanel::contentChanged, &widget, &PanelWidget::showContent);
        QTest::mousePress(key(widget, u"ENTER"_s), Qt::LeftButton);
        pass(2000);
        QTest::mouseRelease(key(widget, u"ENTER"_s), Qt::LeftButton);
        QCOMPARE(widget.content().menuNumber, 1);
        QTest::keyClick(&widget, Qt::Key_Down);
        QCOMPARE(widget.content().body, u"Sensing"_s);
        const QImage before = widget.grab().toImage();
        QTest::keyClick(&widget, Qt::Key_Return);
        QCOMPARE(widget.content().menuNumber, 21);
        QVERIFY(widget.grab().toImage() != before);
    }
};

QTEST_MAIN(TestPanelWidget)
#include "tst_panel_widget.moc"
