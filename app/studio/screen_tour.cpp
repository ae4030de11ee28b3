#include "screen_tour.h"

#include "theme.h"

#include <QApplication>
#include <QDialog>
#include <QPainter>

namespace lds::app {

using namespace Qt::StringLiterals;
using catalog::ItemId;
using Page = ui::MainWindow::Page;

namespace {

constexpr int settleMs = 150;  ///< For layouts and late repaints.
constexpr int mostTries = 200; ///< × settleMs: half a minute for one screen.
constexpr qint64 trendNs = 12'000'000'000;
constexpr QSize large(1440, 900);
constexpr QSize small(1024, 700);

} // namespace

ScreenTour::ScreenTour(ui::MainWindow& window, sensor::Workspace& workspace, emulator::DemoSensor& demo,
                       ports::Scheduler& scheduler, const QDir& folder)
    : m_window(window)
    , m_workspace(workspace)
    , m_demo(demo)
    , m_scheduler(scheduler)
    , m_folder(folder)
{
    planStops();
    planDialogs();
    planThemes();
}

void ScreenTour::start() { next(); }

void ScreenTour::setLook(Page page, const QSize& size, bool dark)
{
    ui::Theme::instance().setMode(dark ? ui::ThemeMode::Dark : ui::ThemeMode::Light);
    m_window.resize(size);
    m_window.showPage(page);
}

bool ScreenTour::edit()
{
    bool done = true;
    for (const auto& [item, text] :
         {std::pair{ItemId::HighSetValue, u"1.75"_s}, std::pair{ItemId::LowSetValue, u"0.75"_s},
          std::pair{ItemId::Hysteresis, u"0.02"_s}})
        done = session()->editText(item, text).has_value() && done;
    session()->edit({{ItemId::AverageTimes, 3}});
    return done;
}

void ScreenTour::planStops()
{
    const auto always = [] { return true; };
    m_stops +=
        {{}, [] {}, [this] { return session() && session()->isReady() && session()->latest().has_value(); }};
    m_stops += {u"settings"_s, [this] { setLook(Page::Settings, large, false); }, always};
    m_stops +=
        {u"settings-edited"_s, [this] { edit(); }, [this] { return session()->pending().count() >= 4; }};
    m_stops += {u"review"_s, [this] { m_window.openReview(); },
                [] { return QApplication::activeModalWidget() != nullptr; }};
    m_stops += {{},
                [] { QApplication::activeModalWidget()->close(); },
                [] { return !QApplication::activeModalWidget(); }};
    m_stops += {u"trend"_s, [this] { setLook(Page::Trend, large, false); },
                [this] {
                    const auto& trend = session()->trend();
                    return !trend.isEmpty() && trend.lastNs() - trend.firstNs() > trendNs;
                }};
    m_stops += {u"messages"_s, [this] { setLook(Page::Messages, large, false); }, always};
}

void ScreenTour::planDialogs()
{
    m_stops += {u"connect"_s,
                [this] {
                    setLook(Page::Settings, large, false);
                    m_window.openConnectDialog();
                },
                [] { return QApplication::activeModalWidget() != nullptr; }};
    m_stops += {{},
                [] { QApplication::activeModalWidget()->close(); },
                [] { return !QApplication::activeModalWidget(); }};
    // Somebody at the keys changes what is being edited here, and stops the laser.
    m_stops += {u"notices"_s,
                [this] {
                    m_demo.post([](emulator::SensorStation& station) {
                        station.sensor().changeByKeypad(ItemId::LowSetValue, -20'000);
                        station.sensor().changeByKeypad(ItemId::LaserStop, 1);
                    });
                },
                [this] {
                    const auto low = session()->pending().find(ItemId::LowSetValue);
                    return low && low->conflict && session()->held(ItemId::LaserStop).value_or(0) == 1;
                }};
    m_stops += {u"review-conflict"_s, [this] { m_window.openReview(); },
                [] { return QApplication::activeModalWidget() != nullptr; }};
    m_stops += {{},
                [] { QApplication::activeModalWidget()->close(); },
                [] { return !QApplication::activeModalWidget(); }};
    m_stops +=
        {{},
         [this] {
             session()->keepMine(ItemId::LowSetValue);
             session()->run(ItemId::LaserStop, 0);
         },
         [this] { return !session()->isRunning() && session()->held(ItemId::LaserStop).value_or(1) == 0; }};
}

void ScreenTour::planThemes()
{
    const auto always = [] { return true; };
    const auto look = [this](Page page, const QSize& size, bool dark) {
        return [this, page, size, dark] { setLook(page, size, dark); };
    };
    m_stops += {u"settings-dark"_s, look(Page::Settings, large, true), always};
    m_stops += {u"trend-dark"_s, look(Page::Trend, large, true), always};
    m_stops += {u"messages-dark"_s, look(Page::Messages, large, true), always};
    m_stops += {u"review-dark"_s,
                [this] {
                    setLook(Page::Settings, large, true);
                    m_window.openReview();
                },
                [] { return QApplication::activeModalWidget() != nullptr; }};
    m_stops += {{},
                [] { QApplication::activeModalWidget()->close(); },
                [] { return !QApplication::activeModalWidget(); }};
    m_stops += {u"settings-small"_s, look(Page::Settings, small, false), always};
    m_stops += {u"trend-small"_s, look(Page::Trend, small, false), always};
    m_stops += {u"messages-small"_s, look(Page::Messages, small, false), always};
    m_stops += {u"settings-small-dark"_s, look(Page::Settings, small, true), always};
    m_stops += {u"trend-small-dark"_s, look(Page::Trend, small, true), always};
    m_stops += {u"disconnected"_s,
                [this] {
                    setLook(Page::Settings, large, false);
                    session()->close();
                },
                always};
    m_stops += {u"no-sensor"_s, [this] { m_workspace.remove(session()); }, [this] { return !session(); }};
}

void ScreenTour::next()
{
    if (++m_current >= int(m_stops.size())) {
        Q_EMIT finished();
        return;
    }
    m_stops.at(m_current).prepare();
    m_scheduler.after(settleMs, this, [this] { lookAgain(mostTries); });
}

void ScreenTour::lookAgain(int triesLeft)
{
    const Stop& stop = m_stops.at(m_current);
    if (stop.isReady()) {
        if (!stop.name.isEmpty())
            render(stop.name);
        next();
    } else if (triesLeft > 0) {
        m_scheduler.after(settleMs, this, [this, triesLeft] { lookAgain(triesLeft - 1); });
    } else {
        Q_EMIT failed(u"The screen \"%1\" (number %2) did not come up."_s.arg(stop.name).arg(m_current));
    }
}

void ScreenTour::render(const QString& name)
{
    QPixmap picture = m_window.grab();
    if (QWidget* dialog = QApplication::activeModalWidget()) {
        QPainter painter(&picture);
        const QRect all(QPoint(), m_window.size());
        painter.fillRect(all, QColor(0, 0, 0, 60));
        QRect place(QPoint(), dialog->size());
        place.moveCenter(all.center());
        painter.drawPixmap(place.topLeft(), dialog->grab());
        painter.setPen(ui::color(ui::ColorRole::Line));
        painter.drawRect(place);
    }
    const QString file =
        m_folder.filePath(u"%1-%2.png"_s.arg(++m_pictures, 2, 10, QLatin1Char('0')).arg(name));
    if (picture.save(file))
        Q_EMIT rendered(file);
    else
        Q_EMIT failed(u"%1 cannot be written. Choose another folder."_s.arg(file));
}

} // namespace lds::app
