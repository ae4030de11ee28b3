#include "frames.h"
#include "message_log.h"

#include <atomic>
#include <QSignalSpy>
#include <QtTest>
#include <thread>
#include <vector>

using namespace lds::ui;

class MessageLogTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void handsOverEverythingInOrderOnce()
    {
        MessageLog log;
        log.record(read(400101, 400101));
        log.record(read(400103, 400104));
        const auto frames = log.take();
        QCOMPARE(frames.size(), 2);
        QCOMPARE(frames[1].arguments.first(), QStringLiteral("400103"));
        QVERIFY(log.take().isEmpty());
    }

    void announcesOnceUntilTaken()
    {
        MessageLog log;
        QSignalSpy waiting(&log, &MessageLog::waiting);
        log.record(poll());
        log.record(poll());
        QCOMPARE(waiting.count(), 1);
        log.take();
        log.record(poll());
        QCOMPARE(waiting.count(), 2);
    }

    void dropsTheOldestBeyondItsBoundAndCountsThem()
    {
        MessageLog log;
        for (int i = 0; i < MessageLog::mostWaiting + 5; ++i)
            log.record(read(i, i));
        quint64 dropped = 0;
        const auto frames = log.take(&dropped);
        QCOMPARE(frames.size(), MessageLog::mostWaiting);
        QCOMPARE(frames.first().arguments.first(), QStringLiteral("5"));
        QCOMPARE(dropped, 5);
        log.record(poll());
        log.take(&dropped);
        QCOMPARE(dropped, 5); // added to, not repeated
    }

    void isBoundInBytesToo()
    {
        MessageLog log;
        auto large = frame(lds::ports::FrameMeaning::Unknown);
        large.bytes = QByteArray(1024 * 1024, 'x');
        for (int i = 0; i < 50; ++i)
            log.record(large);
        qsizetype bytes = 0;
        quint64 dropped = 0;
        const auto frames = log.take(&dropped);
        for (const auto& kept : frames)
            bytes += footprint(kept);
        QVERIFY(bytes <= MessageLog::mostWaitingBytes);
        QVERIFY(!frames.isEmpty());
        QCOMPARE(quint64(frames.size()) + dropped, 50);
    }

    void takesFramesFromManyThreadsWithoutLosingOne()
    {
        MessageLog log;
        constexpr int threads = 4;
        constexpr int each = 3000;
        std::atomic<int> announced = 0;
        connect(
            &log, &MessageLog::waiting, &log, [&] { ++announced; }, Qt::DirectConnection);
        std::vector<std::thread> writers;
        for (int t = 0; t < threads; ++t) {
            writers.emplace_back([&log, t] {
                for (int i = 0; i < each; ++i)
                    log.record(read(t, i));
            });
        }
        std::vector<int> next(threads, 0);
        int total = 0;
        while (total < threads * each) {
            const auto frames = log.take();
            total += int(frames.size());
            for (const auto& taken : frames) // each thread's own order is kept
                QCOMPARE(taken.arguments[1].toInt(), next[taken.arguments[0].toUInt()]++);
        }
        for (std::thread& writer : writers)
            writer.join();
        QVERIFY(announced >= 1);
        QVERIFY(log.take().isEmpty());
    }
};

QTEST_GUILESS_MAIN(MessageLogTest)
#include "tst_message_log.moc"
