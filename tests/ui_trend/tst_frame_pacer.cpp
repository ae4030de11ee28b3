#include "frame_pacer.h"
#include "manual_scheduler.h"

#include <QtTest>

using lds::ports::ManualScheduler;
using lds::ui::FramePacer;

class FramePacerTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aThousandRequestsASecondAreFortyFrames()
    {
        ManualScheduler clock;
        QObject owner;
        int frames = 0;
        FramePacer pacer(clock, &owner, 25, [&] { ++frames; });
        for (int t = 0; t < 1000; ++t) {
            pacer.request();
            clock.advanceMs(1);
        }
        QCOMPARE(frames, 41); // at 0, 25, … 1000 ms
    }

    void aFrameAfterAQuietTimeComesAtOnce()
    {
        ManualScheduler clock;
        QObject owner;
        int frames = 0;
        FramePacer pacer(clock, &owner, 25, [&] { ++frames; });
        pacer.request();
        clock.advanceMs(0);
        QCOMPARE(frames, 1);
        clock.advanceMs(500);
        QCOMPARE(frames, 1); // nobody asked
        pacer.request();
        clock.advanceMs(0);
        QCOMPARE(frames, 2);
    }

    void aLaterFrameIsReplacedByALaterCall()
    {
        ManualScheduler clock;
        QObject owner;
        QList<qint64> frames;
        const qint64 start = clock.nowNs();
        FramePacer pacer(clock, &owner, 25, [&] { frames.append((clock.nowNs() - start) / 1'000'000); });
        pacer.requestAt(start + 500'000'000);
        pacer.requestAt(start + 800'000'000);
        clock.advanceMs(2000);
        QCOMPARE(frames, QList<qint64>{800});
    }

    void aDyingPacerLeavesNothingBehind()
    {
        ManualScheduler clock;
        QObject owner;
        {
            FramePacer pacer(clock, &owner, 25, [] { QFAIL("after its end"); });
            pacer.request();
            pacer.requestAt(clock.nowNs() + 1'000'000);
        }
        QCOMPARE(clock.pendingTimers(), 0);
        clock.advanceMs(100);
    }
};

QTEST_GUILESS_MAIN(FramePacerTest)
#include "tst_frame_pacer.moc"
