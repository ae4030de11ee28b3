#include "fake_link.h"
#include "manual_scheduler.h"
#include "trend_chart.h"
#include "trend_page.h"
#include "workspace.h"

#include <cmath>
#include <QComboBox>
#include <QPushButton>
#include <QtTest>

using namespace lds;
using namespace lds::ui;
using catalog::ItemId;
using measurement::Measurement;
using support::settle;

namespace {

constexpr qint64 second = 1'000'000'000;

/// Counts how often a widget is really painted.
class PaintCounter final : public QObject {
public:
    explicit PaintCounter(QWidget* widget) { widget->installEventFilter(this); }
    int take() { return std::exchange(m_count, 0); }

protected:
    bool eventFilter(QObject*, QEvent* event) override
    {
        m_count += event->type() == QEvent::Paint;
        return false;
    }

private:
    int m_count = 0;
};

} // namespace

/// The trend page on a fake sensor, driven with real mouse and key events; only the test moves the clock.
class TrendFlow : public QObject {
    Q_OBJECT

private:
    struct Fixture {
        ports::ManualScheduler clock;
        support::FakeLinkFactory links{clock};
        sensor::Workspace workspace{links, clock};
        TrendPage page{clock};
        ports::ConnectionUrl url;
        sensor::SensorSession* session = nullptr;

        Fixture()
        {
            ports::registerMetaTypes();
            url.host = QStringLiteral("127.0.0.1");
            url.sensor = catalog::SensorModel::HlG203;
            page.resize(1000, 500);
            session = workspace.add(url);
        }
        ~Fixture()
        {
            page.setSession(nullptr);
            settle();
        }

        support::FakeSensor& sensor() { return links.sensor(url); }
        TrendChart& chart() { return page.chart(); }
        const TrendScene& scene() { return chart().scene(); }
        TrendSpan span() { return scene().scale.span; }

        void open()
        {
            sensor().set(ItemId::HighSetValue, 17'500);
            sensor().set(ItemId::LowSetValue, 7'500);
            session->open();
            settle();
            page.setSession(session);
            page.show();
            QVERIFY(QTest::qWaitForWindowExposed(&page));
            page.activateWindow();
            chart().setFocus();
            frames();
        }
        void frames(int ms = 100)
        {
            clock.advanceMs(ms);
            settle();
        }
        Measurement sample(catalog::Value value, quint16 state)
        {
            Measurement result;
            result.monotonicNs = clock.nowNs();
            result.wallMs = clock.wallMs();
            result.value = value;
            result.kind = measurement::ValueKind::Valid;
            result.state = quint16(state | measurement::LaserBit);
            return result;
        }
        /// A hundred samples a second for `ms`, in batches of a tenth of a second as a link sends them.
        void measure(int ms, catalog::Value around = 12'000, quint16 state = measurement::GoBit)
        {
            measurement::MeasurementBatch batch;
            for (int gone = 0; gone < ms; gone += 10) {
                clock.advanceMs(10);
                batch.append(sample(around + gone % 70, state));
                if (batch.size() < 10 && gone + 10 < ms)
                    continue;
                sensor().emitBatch(std::exchange(batch, {}));
                settle();
            }
        }
        QPushButton* button(const QString& text)
        {
            for (auto* candidate : page.findChildren<QPushButton*>()) {
                if (candidate->text() == text)
                    return candidate;
            }
            return nullptr;
        }
        QPoint at(double x, double y) // fractions of the plot
        {
            const QRectF plot = scene().layout.plot;
            return QPointF(plot.left() + x * plot.width(), plot.top() + y * plot.height()).toPoint();
        }
        void wheel(const QPoint& place, int notches, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
        {
            QWheelEvent event(place, chart().viewport()->mapToGlobal(place), {}, {0, 120 * notches},
                              Qt::NoButton, modifiers, Qt::NoScrollPhase, false);
            QCoreApplication::sendEvent(chart().viewport(), &event);
            frames();
        }
        void key(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
        {
            QTest::keyClick(&chart(), Qt::Key(key), modifiers);
            frames();
        }
        void drag(const QPoint& from, const QPoint& to)
        {
            QWidget* target = chart().viewport();
            QTest::mousePress(target, Qt::LeftButton, {}, from);
            for (const double part : {0.3, 0.7, 1.0}) {
                const QPoint place = from + (QPointF(to - from) * part).toPoint();
                QMouseEvent move(QEvent::MouseMove, place, target->mapToGlobal(place), Qt::NoButton,
                                 Qt::LeftButton, {});
                QCoreApplication::sendEvent(target, &move);
            }
            QTest::mouseRelease(target, Qt::LeftButton, {}, to);
            frames();
        }
    };

private Q_SLOTS:
    void withoutASensorThePageSaysWhatToDo()
    {
        Fixture f;
        f.page.show();
        QVERIFY(QTest::qWaitForWindowExposed(&f.page));
        f.frames();
        QVERIFY(!f.scene().hasData);
        QVERIFY(f.scene().notice.detail.contains(QStringLiteral("Connect")));
        for (auto* control : f.page.findChildren<QPushButton*>())
            QVERIFY(!control->isEnabled());
    }

    void theLineFollowsTheSensor()
    {
        Fixture f;
        f.open();
        QCOMPARE(f.scene().notice.title, QStringLiteral("Waiting for the first value"));
        f.measure(3000);
        f.frames();
        QVERIFY(f.scene().hasData);
        QVERIFY(f.scene().notice.isEmpty());
        QCOMPARE(f.span().toNs, f.session->trend().lastNs());
        QCOMPARE(f.span().lengthNs(), 10 * second);
        const QList<QPointF> points = f.chart().series().pool().first()->points();
        QVERIFY(points.size() > 100);
        QVERIFY(points.last().x() > f.scene().layout.plot.width() - 3);
        f.measure(1000);
        f.frames();
        QCOMPARE(f.span().toNs, f.session->trend().lastNs());
    }

    void aStretchWithoutValuesIsAGapAndAnAlarmInTheStrip()
    {
        Fixture f;
        f.open();
        f.measure(1000);
        for (int i = 0; i < 50; ++i) {
            f.clock.advanceMs(10);
            Measurement alarm = f.sample(9'999'999, measurement::AlarmBit);
            alarm.kind = measurement::ValueKind::Alarm;
            f.sensor().emitMeasurement(alarm);
            settle();
        }
        f.measure(1000);
        f.frames();
        int pieces = 0;
        for (const QLineSeries* series : f.chart().series().pool())
            pieces += series->count() > 0;
        QCOMPARE(pieces, 2);
        QCOMPARE(f.scene().states[3].size(), 1);
        QCOMPARE(f.scene().states[1].size(), 2);
        QVERIFY(f.scene().frozen.isEmpty());
    }

    void frozenValuesUnderAnAlarmAreMarked()
    {
        Fixture f;
        f.open();
        f.measure(1000);
        f.measure(500, 12'000, measurement::AlarmBit | measurement::GoBit);
        f.measure(500);
        f.frames();
        QCOMPARE(f.scene().frozen.size(), 1);
    }

    void aThousandSamplesASecondAreAtMostFortyFrames()
    {
        Fixture f;
        f.open();
        f.measure(1000);
        PaintCounter painted(f.chart().viewport());
        for (int i = 0; i < 1000; ++i) {
            f.clock.advanceMs(1);
            f.sensor().emitMeasurement(f.sample(12'000 + i % 50, measurement::GoBit));
            settle();
        }
        const int frames = painted.take();
        QVERIFY2(frames >= 20 && frames <= 42, qPrintable(QString::number(frames)));
    }

    void nothingIsPaintedWhileHiddenPausedOrUnchanged()
    {
        Fixture f;
        f.open();
        f.measure(1000);
        f.frames(3000);
        PaintCounter painted(f.chart().viewport());
        f.frames(3000);
        QCOMPARE(painted.take(), 0); // nothing arrived
        f.key(Qt::Key_Space);
        f.frames(3000);
        painted.take();
        f.measure(1000);
        f.frames();
        QCOMPARE(painted.take(), 0); // paused
        f.key(Qt::Key_Space);
        QVERIFY(painted.take() > 0);
        const qint64 shown = f.span().toNs;
        f.page.hide();
        f.measure(1000);
        f.frames();
        QCOMPARE(f.span().toNs, shown);
        f.page.show();
        f.frames();
        QCOMPARE(f.span().toNs, f.session->trend().lastNs());
    }

    void pauseHoldsTheViewStillWhileValuesArrive()
    {
        Fixture f;
        f.open();
        f.measure(2000);
        f.frames();
        const TrendSpan before = f.span();
        QTest::mouseClick(f.button(QStringLiteral("Pause")), Qt::LeftButton);
        f.measure(2000);
        f.frames();
        QCOMPARE(f.span(), before);
        QVERIFY(f.session->trend().lastNs() > before.toNs + second);
        QTest::mouseClick(f.button(QStringLiteral("Go on")), Qt::LeftButton);
        f.frames();
        QCOMPARE(f.span().toNs, f.session->trend().lastNs());
        QVERIFY(f.button(QStringLiteral("Pause")));
    }

    void aPausedWindowThatReachesPastTheNewestValueStaysAsItIs()
    {
        Fixture f;
        f.open();
        f.measure(5000);
        f.frames();
        f.chart().setWindowLength(60 * second);
        f.key(Qt::Key_Right);
        f.key(Qt::Key_Right); // twelve seconds still to come lie inside the window
        QVERIFY(f.span().toNs > f.session->trend().lastNs() + 10 * second);
        f.key(Qt::Key_Space);
        f.frames(3000);
        PaintCounter painted(f.chart().viewport());
        f.measure(500);
        f.frames();
        QCOMPARE(painted.take(), 0);
        f.key(Qt::Key_Space);
        painted.take();
        f.measure(300);
        f.frames();
        QVERIFY(painted.take() > 0); // looking on, not paused: what arrives is drawn
    }

    void arrowsPanAndEndFollowsAgain()
    {
        Fixture f;
        f.open();
        f.measure(20'000);
        f.frames();
        const TrendSpan before = f.span();
        f.key(Qt::Key_Left);
        QCOMPARE(f.span().toNs, before.toNs - second);
        QVERIFY(!f.button(QStringLiteral("Follow"))->isChecked());
        f.measure(500);
        f.frames();
        QCOMPARE(f.span().toNs, before.toNs - second);
        f.key(Qt::Key_End);
        QCOMPARE(f.span().toNs, f.session->trend().lastNs());
        QVERIFY(f.button(QStringLiteral("Follow"))->isChecked());
        f.key(Qt::Key_Home);
        QCOMPARE(f.span().fromNs, f.session->trend().firstNs());
    }

    void keysZoomTimeAndValuesAndFitShowsAll()
    {
        Fixture f;
        f.open();
        f.measure(20'000);
        f.frames();
        f.key(Qt::Key_Plus);
        QCOMPARE(f.span().lengthNs(), 8 * second);
        QCOMPARE(f.span().toNs, f.session->trend().lastNs());
        f.key(Qt::Key_Minus);
        f.key(Qt::Key_Minus);
        QVERIFY(std::abs(f.span().lengthNs() - 125 * second / 10) < second / 100);
        const double height = f.scene().scale.range.span();
        f.key(Qt::Key_Plus, Qt::ControlModifier);
        QVERIFY(std::abs(f.scene().scale.range.span() / height - 0.8) < 1e-6);
        const double low = f.scene().scale.range.low;
        f.key(Qt::Key_Up);
        QVERIFY(f.scene().scale.range.low > low);
        f.key(Qt::Key_F);
        QCOMPARE(f.span().fromNs, f.session->trend().firstNs());
        QCOMPARE(f.span().toNs, f.session->trend().lastNs());
        QVERIFY(f.scene().scale.range.low < 7'500); // fitted again, LOW in sight
    }

    void theWheelZoomsAroundThePointer()
    {
        Fixture f;
        f.open();
        f.measure(20'000);
        f.frames();
        const QPoint place = f.at(0.25, 0.5);
        const auto pointed = [&] { return f.scene().scale.timeAt(place.x() - f.scene().layout.plot.left()); };
        const qint64 before = pointed();
        f.wheel(place, 2);
        QVERIFY(std::abs(f.span().lengthNs() - 64 * second / 10) < 1000);
        QVERIFY(std::abs(pointed() - before) < f.span().lengthNs() / 500);
        f.wheel(place, -2);
        QVERIFY(std::abs(pointed() - before) < f.span().lengthNs() / 500);
    }

    void theWheelWithControlZoomsValuesAroundThePointer()
    {
        Fixture f;
        f.open();
        f.measure(5000);
        f.frames();
        const QPoint place = f.at(0.5, 0.25);
        const auto pointed = [&] {
            return f.scene().scale.valueAt(f.scene().layout.plot.bottom() - place.y());
        };
        const double before = pointed();
        const TrendSpan span = f.span();
        f.wheel(place, 3, Qt::ControlModifier);
        QVERIFY(std::abs(pointed() - before) < f.scene().scale.range.span() / 200);
        QCOMPARE(f.span().lengthNs(), span.lengthNs());
        const double height = f.scene().scale.range.span();
        f.wheel({10, place.y()}, 1); // over the axis no key is needed
        QVERIFY(f.scene().scale.range.span() < height);
    }

    void draggingPansAndLeavesFollow()
    {
        Fixture f;
        f.open();
        f.measure(20'000);
        f.frames();
        const TrendSpan before = f.span();
        f.drag(f.at(0.2, 0.5), f.at(0.7, 0.5));
        const double moved = double(before.toNs - f.span().toNs) / double(before.lengthNs());
        QVERIFY2(std::abs(moved - 0.5) < 0.01, qPrintable(QString::number(moved)));
        QVERIFY(!f.button(QStringLiteral("Follow"))->isChecked());
    }

    void aClickIsNoDrag()
    {
        Fixture f;
        f.open();
        f.measure(5000);
        f.frames();
        f.drag(f.at(0.5, 0.5), f.at(0.5, 0.5) + QPoint(2, 1));
        QVERIFY(f.button(QStringLiteral("Follow"))->isChecked());
    }

    void draggingTheValueAxisZoomsValuesAndADoubleClickFitsAgain()
    {
        Fixture f;
        f.open();
        f.measure(20'000);
        f.key(Qt::Key_End);
        const TrendValueScale::Range before = f.scene().scale.range;
        const int middle = f.at(0, 0.5).y();
        f.drag({12, middle}, {12, middle - 100});
        QVERIFY(std::abs(f.scene().scale.range.span() / before.span() - 0.5) < 0.01);
        f.key(Qt::Key_Left);
        QTest::mouseDClick(f.chart().viewport(), Qt::LeftButton, {}, f.at(0.5, 0.5));
        f.frames();
        QCOMPARE(f.scene().scale.range, before);
        QVERIFY(f.button(QStringLiteral("Follow"))->isChecked());
        QCOMPARE(f.span().toNs, f.session->trend().lastNs());
    }

    void aWindowLengthIsChosenByKeyboard()
    {
        Fixture f;
        f.open();
        f.measure(20'000);
        f.frames();
        auto* length = f.page.findChild<QComboBox*>();
        QCOMPARE(length->currentText(), QStringLiteral("10 s"));
        length->setFocus();
        QTest::keyClick(length, Qt::Key_Down);
        f.frames();
        QCOMPARE(length->currentText(), QStringLiteral("1 min"));
        QCOMPARE(f.span().lengthNs(), 60 * second);
        QTest::keyClick(length, Qt::Key_End);
        f.frames();
        QCOMPARE(f.span(), (TrendSpan{f.session->trend().firstNs(), f.session->trend().lastNs()}));
        f.key(Qt::Key_Plus); // a length that is no choice is still told
        QCOMPARE(length->currentIndex(), -1);
        QVERIFY(!length->placeholderText().isEmpty());
    }

    void highAndLowFollowTheSensorAndPendingEditsStandBeside()
    {
        Fixture f;
        f.open();
        f.measure(500);
        f.frames();
        QCOMPARE(f.scene().limits.high.held, std::optional(17'500));
        QCOMPARE(f.scene().limits.high.heldText, QStringLiteral("HIGH +1.7500"));
        QVERIFY(!f.scene().limits.high.wanted);
        f.session->edit({{ItemId::HighSetValue, 18'000}});
        f.frames();
        QCOMPARE(f.scene().limits.high.held, std::optional(17'500));
        QCOMPARE(f.scene().limits.high.wanted, std::optional(18'000));
        QVERIFY(f.scene().limits.high.wantedText.contains(QStringLiteral("+1.8000")));
        QVERIFY(f.session->apply());
        settle();
        f.frames();
        QCOMPARE(f.scene().limits.high.held, std::optional(18'000));
        QVERIFY(!f.scene().limits.high.wanted);
    }

    void aCutIsSaidAndTheLastLineStays()
    {
        Fixture f;
        f.open();
        f.measure(2000);
        f.frames();
        f.sensor().failOpenings(ports::OpenFailure::Refused);
        f.sensor().cut();
        settle();
        f.frames();
        QVERIFY(f.scene().hasData);
        QVERIFY(!f.scene().notice.isEmpty());
        QVERIFY(f.scene().limits.stale);
        f.sensor().allowOpenings();
        f.clock.advanceMs(10'000);
        settle();
        f.measure(100);
        f.frames();
        QVERIFY(f.scene().notice.isEmpty());
        QVERIFY(!f.scene().limits.stale);
    }

    void aStoppedLaserAndASensorInItsMenuAreSaid()
    {
        Fixture f;
        f.open();
        f.measure(500);
        Measurement dark = f.sample(-9'999'999, measurement::IndeterminateBit);
        dark.kind = measurement::ValueKind::Indeterminate;
        dark.state = measurement::IndeterminateBit;
        f.sensor().emitMeasurement(dark);
        settle();
        f.frames();
        QCOMPARE(f.scene().notice.title, QStringLiteral("Laser stopped"));
        f.measure(100);
        QVERIFY(f.scene().notice.isEmpty());
        f.sensor().refusePoll(ports::FailureCode::NotReady);
        settle();
        f.frames();
        QCOMPARE(f.scene().notice.title, QStringLiteral("Sensor not ready"));
    }

    void thePointerReadsTimeAndValues()
    {
        Fixture f;
        f.open();
        f.measure(5000);
        f.frames();
        const QPoint place = f.at(0.8, 0.5);
        QMouseEvent move(QEvent::MouseMove, place, f.chart().viewport()->mapToGlobal(place), Qt::NoButton, {},
                         {});
        QCoreApplication::sendEvent(f.chart().viewport(), &move);
        f.frames();
        QVERIFY(f.scene().pointer);
        const auto readout = readoutAt(f.scene(), f.scene().pointer->x() - f.scene().layout.plot.left());
        QVERIFY(readout);
        QVERIFY2(readout->value.startsWith(QStringLiteral("+1.20")), qPrintable(readout->value));
        QCOMPARE(readout->state, QStringLiteral("GO"));
        QEvent leave(QEvent::Leave);
        QCoreApplication::sendEvent(f.chart().viewport(), &leave);
        QVERIFY(!f.scene().pointer);
    }

    void eachSensorKeepsItsOwnView()
    {
        Fixture f;
        f.open();
        f.measure(20'000);
        f.frames();
        f.key(Qt::Key_Left);
        const TrendSpan first = f.span();
        ports::ConnectionUrl other = f.url;
        other.port = 1502;
        sensor::SensorSession* second = f.workspace.add(other);
        f.page.setSession(second);
        f.frames();
        QVERIFY(!f.scene().hasData);
        QVERIFY(f.button(QStringLiteral("Follow"))->isChecked());
        f.page.setSession(f.session);
        f.frames();
        QCOMPARE(f.span(), first);
        QVERIFY(!f.button(QStringLiteral("Follow"))->isChecked());
    }

    void aSensorThatGoesAwayLeavesAnEmptyPage()
    {
        Fixture f;
        f.open();
        f.measure(1000);
        f.frames();
        f.workspace.remove(f.session); // without telling the page
        settle();
        f.frames();
        QVERIFY(!f.scene().hasData);
        QCOMPARE(f.scene().notice.title, QStringLiteral("No sensor"));
        f.key(Qt::Key_Left);
        f.key(Qt::Key_Space);
    }

    void aScreenReaderHearsWhatIsShown()
    {
        Fixture f;
        f.open();
        f.measure(1000);
        f.frames();
        QVERIFY(!f.chart().accessibleName().isEmpty());
        const QString told = f.chart().accessibleDescription();
        QVERIFY2(told.contains(QStringLiteral("10 s")) && told.contains(QStringLiteral("HIGH +1.7500 mm")),
                 qPrintable(told));
        f.key(Qt::Key_Space);
        QVERIFY(f.chart().accessibleDescription().contains(QStringLiteral("paused")));
        for (const QComboBox* box : f.page.findChildren<QComboBox*>())
            QVERIFY(!box->accessibleName().isEmpty());
    }
};

QTEST_MAIN(TrendFlow)
#include "flow_trend.moc"
