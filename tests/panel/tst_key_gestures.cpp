#include "key_gestures.h"
#include "manual_clock.h"

#include <QTest>

using namespace lds::emulator;

/// When a press means what (§4.9, §4.10, §4.11, §4.12, §2.2).
class TestKeyGestures : public QObject {
    Q_OBJECT

private:
    struct Hands {
        ManualClock clock;
        QList<Gesture> done;
        KeyGestures keys{clock, [this](Gesture gesture) { done.append(gesture); }};
    };

private Q_SLOTS:
    void a_key_let_go_soon_is_a_short_press_at_its_release()
    {
        Hands hands;
        hands.keys.press(Key::Enter);
        hands.clock.advanceMs(1999);
        QVERIFY(hands.done.isEmpty());
        hands.keys.release(Key::Enter);
        QCOMPARE(hands.done, QList{Gesture::Enter});
    }

    void a_key_held_for_two_seconds_is_a_long_press_and_nothing_more()
    {
        Hands hands;
        hands.keys.press(Key::Up);
        hands.clock.advanceMs(2000);
        QCOMPARE(hands.done, QList{Gesture::HoldUp});
        hands.clock.advanceMs(5000);
        hands.keys.release(Key::Up);
        QCOMPARE(hands.done, QList{Gesture::HoldUp});
    }

    void up_and_down_are_decided_at_the_release_or_after_two_seconds()
    {
        Hands soon;
        soon.keys.press(Key::Up);
        soon.keys.press(Key::Down);
        soon.clock.advanceMs(1999);
        QVERIFY(soon.done.isEmpty());
        soon.keys.release(Key::Down);
        soon.keys.release(Key::Up);
        QCOMPARE(soon.done, QList{Gesture::UpDown});

        Hands late;
        late.keys.press(Key::Down);
        late.clock.advanceMs(500);
        late.keys.press(Key::Up);
        late.clock.advanceMs(1999);
        QVERIFY(late.done.isEmpty()); // two seconds together
        late.clock.advanceMs(1);
        late.keys.release(Key::Down);
        late.keys.release(Key::Up);
        QCOMPARE(late.done, QList{Gesture::HoldUpDown});
    }

    void pairs_with_enter_act_at_once()
    {
        Hands hands;
        hands.keys.press(Key::Down);
        hands.keys.press(Key::Enter);
        QCOMPARE(hands.done, QList{Gesture::DownEnter});
        hands.keys.release(Key::Enter);
        hands.clock.advanceMs(3000);
        hands.keys.release(Key::Down);
        QCOMPARE(hands.done, QList{Gesture::DownEnter});

        hands.keys.press(Key::Enter);
        hands.keys.press(Key::Up);
        QCOMPARE(hands.done, (QList{Gesture::DownEnter, Gesture::UpEnter}));
    }

    void three_keys_mean_nothing()
    {
        Hands hands;
        hands.keys.press(Key::Up);
        hands.keys.press(Key::Down);
        hands.keys.press(Key::Enter);
        hands.clock.advanceMs(3000);
        for (const Key key : {Key::Up, Key::Enter, Key::Down})
            hands.keys.release(key);
        QVERIFY(hands.done.isEmpty());
        hands.keys.press(Key::Up);
        hands.keys.release(Key::Up);
        QCOMPARE(hands.done, QList{Gesture::Up});
    }

    void what_is_swallowed_means_nothing_until_all_keys_are_up()
    {
        Hands hands;
        hands.keys.press(Key::Up);
        hands.keys.swallow();
        hands.clock.advanceMs(3000);
        hands.keys.release(Key::Up);
        QVERIFY(hands.done.isEmpty());
        hands.keys.press(Key::Down);
        hands.keys.release(Key::Down);
        QCOMPARE(hands.done, QList{Gesture::Down});
    }

    void a_key_that_is_down_already_and_one_that_is_not_are_ignored()
    {
        Hands hands;
        hands.keys.release(Key::Up);
        hands.keys.press(Key::Up);
        hands.clock.advanceMs(1000);
        hands.keys.press(Key::Up);
        hands.clock.advanceMs(1000);
        QCOMPARE(hands.done, QList{Gesture::HoldUp});
    }
};

QTEST_GUILESS_MAIN(TestKeyGestures)
#include "tst_key_gestures.moc"
